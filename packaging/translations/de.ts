<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>System Default</source>
        <translation>Systemvorgabe</translation>
    </message>
    <message>
        <source>Takes effect at the next start</source>
        <translation>Gilt ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Outside sRGB: this screen shows the nearest colour by clipping. The paint itself is not clipped.</source>
        <translation>Außerhalb von sRGB: Dieser Bildschirm zeigt durch Abschneiden die nächste Farbe. Der Lack selbst wird nicht beschnitten.</translation>
    </message>
    <message>
        <source>Colour difference CIEDE2000 between what is asked and what the fitted lobes give.</source>
        <translation>Farbabstand CIEDE2000 zwischen dem Verlangten und dem, was die angepassten Keulen ergeben.</translation>
    </message>
    <message>
        <source>Flop over the aspecular angle: what is asked above, what the fitted lobes give below</source>
        <translation>Flop über dem Aspekularwinkel: oben das Verlangte, unten was die angepassten Keulen ergeben</translation>
    </message>
    <message>
        <source>Flop: asked above, fitted lobes below</source>
        <translation>Flop: oben verlangt, unten angepasst</translation>
    </message>
    <message>
        <source>Flop over the aspecular angle</source>
        <translation>Flop über dem Aspekularwinkel</translation>
    </message>
    <message>
        <source>The grips move the flop about a face that stays: L, C and h at either end the travel of lightness, chroma and hue, F the flop index. Drag one up or down, or choose one with Left and Right and move it with Up and Down (Shift: finely).</source>
        <translation>Die Griffe bewegen den Flop um eine Aufsicht, die bleibt: L, C und h an beiden Enden den Weg von Helligkeit, Buntheit und Buntton, F den Flop-Index. Einen nach oben oder unten ziehen, oder mit Pfeil links und rechts wählen und mit Pfeil auf und ab bewegen (Umschalt: fein).</translation>
    </message>
    <message>
        <source>Colour at {angle}: {lab}</source>
        <translation>Farbe bei {angle}: {lab}</translation>
    </message>
    <message>
        <source>batch</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>fit: none</source>
        <translation>Anpassung: keine</translation>
    </message>
    <message>
        <source>fit ΔE00 {error:.2f}</source>
        <translation>Anpassung ΔE00 {error:.2f}</translation>
    </message>
    <message>
        <source>{fit}, time-limited</source>
        <translation>{fit}, vom Zeitlimit beendet</translation>
    </message>
    <message>
        <source>near-specular</source>
        <translation>Glanzwinkelnähe</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Aufsicht</translation>
    </message>
    <message>
        <source>near end</source>
        <translation>nahes Ende</translation>
    </message>
    <message>
        <source>far end</source>
        <translation>fernes Ende</translation>
    </message>
    <message>
        <source>Drag it up or down, or press Up and Down (Shift: finely): this end follows, the far end goes the other way, and the face stays. A double click goes back to the document as it was opened.</source>
        <translation>Nach oben oder unten ziehen, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein): Dieses Ende folgt, das ferne geht entgegengesetzt, und die Aufsicht bleibt. Ein Doppelklick geht zum Stand beim Öffnen zurück.</translation>
    </message>
    <message>
        <source>Drag it up for more flop and down for less, or press Up and Down (Shift: finely); the face stays. A double click goes back to the document as it was opened.</source>
        <translation>Nach oben ziehen für mehr Flop, nach unten für weniger, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein); die Aufsicht bleibt. Ein Doppelklick geht zum Stand beim Öffnen zurück.</translation>
    </message>
    <message>
        <source>Drag it up or down, or press Up and Down (Shift: finely): this end follows, the near end goes the other way, and the face stays. A double click goes back to the document as it was opened.</source>
        <translation>Nach oben oder unten ziehen, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein): Dieses Ende folgt, das nahe geht entgegengesetzt, und die Aufsicht bleibt. Ein Doppelklick geht zum Stand beim Öffnen zurück.</translation>
    </message>
    <message>
        <source>{value}, from {near:g}° to {far:g}° ({place})</source>
        <translation>{value}, von {near:g}° bis {far:g}° ({place})</translation>
    </message>
    <message>
        <source>flop</source>
        <translation>Flop</translation>
    </message>
    <message>
        <source>Flop: of the last paint that can be</source>
        <translation>Flop: vom letzten möglichen Lack</translation>
    </message>
    <message>
        <source>Flop strip</source>
        <translation>Flop-Streifen</translation>
    </message>
    <message>
        <source>“{name}”</source>
        <translation>„{name}“</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>{count} weitere</translation>
    </message>
    <message>
        <source>Unsaved work on {count} paints was found, the newest from {when}: {names}.</source>
        <translation>Ungesicherte Arbeit an {count} Lacken wurde gefunden, die neueste von {when}: {names}.</translation>
    </message>
    <message>
        <source>Recover All</source>
        <translation>Alle wiederherstellen</translation>
    </message>
    <message>
        <source>One by One</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>An earlier run ended before they were saved. Each opens in a tab; no file is changed.</source>
        <translation>Ein früherer Lauf endete, bevor sie gesichert waren. Jeder öffnet sich in einem Reiter; keine Datei wird geändert.</translation>
    </message>
    <message>
        <source>Unsaved work on “{name}” was found, from {when}.</source>
        <translation>Ungesicherte Arbeit an „{name}“ wurde gefunden, von {when}.</translation>
    </message>
    <message>
        <source>{what} After it: {count} more.</source>
        <translation>{what} Danach: {count} weitere.</translation>
    </message>
    <message>
        <source>An earlier run ended before it was saved. Recover opens it; the file on disk is unchanged.</source>
        <translation>Ein früherer Lauf endete, bevor sie gesichert war. „Wiederherstellen“ öffnet sie; die Datei bleibt unverändert.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Open paints</source>
        <translation>Offene Lacke</translation>
    </message>
    <message>
        <source>Not yet in a file</source>
        <translation>Noch in keiner Datei</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gesichert</translation>
    </message>
    <message>
        <source>{title}, not saved</source>
        <translation>{title}, nicht gesichert</translation>
    </message>
    <message>
        <source>Close {title}</source>
        <translation>{title} schließen</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Coat</source>
        <translation>Klarlack</translation>
    </message>
    <message>
        <source>Flakes</source>
        <translation>Flakes</translation>
    </message>
    <message>
        <source>A few lobes stand for the whole table; points are measured, the line is the fit, dashed lines are its parts.</source>
        <translation>Wenige Lappen stehen für die ganze Tabelle; Punkte sind gemessen, die Linie ist die Anpassung, gestrichelt sind ihre Teile.</translation>
    </message>
    <message>
        <source>Measured reflectance and its fit</source>
        <translation>Gemessene Reflexion und ihre Anpassung</translation>
    </message>
    <message>
        <source>f_r (1/sr)</source>
        <translation>f_r (1/sr)</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Parameters of the fit</source>
        <translation>Parameter der Anpassung</translation>
    </message>
    <message>
        <source>Weights kd and ks per channel, slope m of the facets, reflectance r at the normal; ± standard uncertainty</source>
        <translation>Gewichte kd und ks je Kanal, Neigung m der Facetten, Reflexionsgrad r an der Normalen; ± Standardunsicherheit</translation>
    </message>
    <message>
        <source>Cook-Torrance</source>
        <translation>Cook-Torrance</translation>
    </message>
    <message>
        <source>GGX lobes</source>
        <translation>GGX-Lappen</translation>
    </message>
    <message>
        <source>GGX lobes, clearcoat</source>
        <translation>GGX-Lappen, Klarlack</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The shape of the lobes; only Cook-Torrance becomes a paint</source>
        <translation>Die Form der Lappen; nur aus Cook-Torrance wird ein Lack</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Lappen</translation>
    </message>
    <message>
        <source>How many; the last one stands for the sharp peak</source>
        <translation>Wie viele; der letzte steht für die scharfe Spitze</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Fit the lobes to the table; some seconds</source>
        <translation>Die Lappen an die Tabelle anpassen; einige Sekunden</translation>
    </message>
    <message>
        <source>Fit the Lobes</source>
        <translation>Lappen anpassen</translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation>Leuchtdichte</translation>
    </message>
    <message>
        <source>All three</source>
        <translation>Alle drei</translation>
    </message>
    <message>
        <source>θd</source>
        <translation>θd</translation>
    </message>
    <message>
        <source>Angle between light and half vector, along which the curves are drawn</source>
        <translation>Winkel zwischen Licht und Halbvektor, bei dem die Kurven gezeichnet sind</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Linear Rec. 2020</source>
        <translation>Lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>How well the fit stands for the table</source>
        <translation>Wie gut die Anpassung für die Tabelle steht</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Open as New Paint</source>
        <translation>Als neuen Lack öffnen</translation>
    </message>
    <message>
        <source>Start a design in Designer from it, in a tab of its own; nothing is saved yet</source>
        <translation>Daraus einen Entwurf in Designer beginnen, in einem eigenen Reiter; gespeichert ist noch nichts</translation>
    </message>
    <message>
        <source>Save Paint…</source>
        <translation>Lack speichern …</translation>
    </message>
    <message>
        <source>Save the lobes themselves as a .brdfpaint that Viewer opens</source>
        <translation>Die Lappen selbst als .brdfpaint speichern, die Viewer öffnet</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Not fitted yet.</source>
        <translation>Noch nicht angepasst.</translation>
    </message>
    <message>
        <source>There is no table yet: the reconstruction makes it.</source>
        <translation>Es gibt noch keine Tabelle: Die Rekonstruktion macht sie.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>diffuse</source>
        <translation>diffus</translation>
    </message>
    <message>
        <source>lobe {number}</source>
        <translation>Lappen {number}</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Lack</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open S&amp;hipped Paint</source>
        <translation>Mitgelieferten Lack öff&amp;nen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Sichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Sichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Close Tab</source>
        <translation>Reiter s&amp;chließen</translation>
    </message>
    <message>
        <source>Reopen Closed &amp;Tab</source>
        <translation>Geschlossenen &amp;Reiter wieder öffnen</translation>
    </message>
    <message>
        <source>&amp;Next Tab</source>
        <translation>&amp;Nächster Reiter</translation>
    </message>
    <message>
        <source>&amp;Previous Tab</source>
        <translation>&amp;Voriger Reiter</translation>
    </message>
    <message>
        <source>Open &amp;Viewer</source>
        <translation>&amp;Viewer öffnen</translation>
    </message>
    <message>
        <source>Find a command by name</source>
        <translation>Befehl nach Namen suchen</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>Enter or a click runs the command; the arrow keys choose another</source>
        <translation>Eingabe oder Klick führt den Befehl aus; die Pfeiltasten wählen einen anderen</translation>
    </message>
    <message>
        <source>No matching command.</source>
        <translation>Kein passender Befehl.</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Ungesicherte Änderungen</translation>
    </message>
    <message>
        <source>Save changes to “{name}”?</source>
        <translation>Änderungen an „{name}“ sichern?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>Ohne Sichern gehen die Änderungen verloren.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Datei geändert</translation>
    </message>
    <message>
        <source>“{name}” was changed by another program since it was opened or saved here.</source>
        <translation>„{name}“ wurde von einem anderen Programm geändert, seit sie hier geöffnet oder gesichert wurde.</translation>
    </message>
    <message>
        <source>Overwriting discards the changes of the other program.</source>
        <translation>Beim Überschreiben gehen die Änderungen des anderen Programms verloren.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Sichern unter …</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Sichern unter</translation>
    </message>
    <message>
        <source>The fit reached its time limit. This is the best result so far; the exact one follows automatically.</source>
        <translation>Die Anpassung hat ihr Zeitlimit erreicht. Dies ist das bisher beste Ergebnis; das genaue folgt automatisch.</translation>
    </message>
    <message>
        <source>The fit reached its time limit. This is the best result that was found; no exact one will follow.</source>
        <translation>Die Anpassung hat ihr Zeitlimit erreicht. Dies ist das beste gefundene Ergebnis; ein genaues folgt nicht.</translation>
    </message>
    <message>
        <source>ΔE00 above {limit}: the fit reached its time limit; the exact result follows automatically.</source>
        <translation>ΔE00 über {limit}: Die Anpassung hat ihr Zeitlimit erreicht; das genaue Ergebnis folgt automatisch.</translation>
    </message>
    <message>
        <source>ΔE00 above {limit}: the fit reached its time limit; no exact result will follow.</source>
        <translation>ΔE00 über {limit}: Die Anpassung hat ihr Zeitlimit erreicht; ein genaues Ergebnis folgt nicht.</translation>
    </message>
    <message>
        <source>ΔE00 above {limit}: no non-negative sum of the lobes reaches this colour. The picture shows what they do give.</source>
        <translation>ΔE00 über {limit}: Keine nichtnegative Summe der Keulen erreicht diese Farbe. Das Bild zeigt, was sie ergeben.</translation>
    </message>
    <message>
        <source>Drag a number sideways</source>
        <translation>Eine Zahl seitwärts ziehen</translation>
    </message>
    <message>
        <source>Change it; Shift fine, Ctrl coarse</source>
        <translation>Ändern; Umschalt fein, Strg grob</translation>
    </message>
    <message>
        <source>Double click a number</source>
        <translation>Doppelklick auf eine Zahl</translation>
    </message>
    <message>
        <source>Reset it</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Wheel on a focused number or slider</source>
        <translation>Mausrad auf gewählter Zahl oder Regler</translation>
    </message>
    <message>
        <source>Step it</source>
        <translation>Schrittweise ändern</translation>
    </message>
    <message>
        <source>Left drag in a picture</source>
        <translation>Links im Bild ziehen</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umkreisen</translation>
    </message>
    <message>
        <source>Middle or Shift drag in a picture</source>
        <translation>Mit der Mitte oder mit Umschalt im Bild ziehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Wheel in a picture</source>
        <translation>Mausrad im Bild</translation>
    </message>
    <message>
        <source>Zoom to the cursor</source>
        <translation>Zum Zeiger zoomen</translation>
    </message>
    <message>
        <source>Right or Alt drag in a picture</source>
        <translation>Rechts oder mit Alt im Bild ziehen</translation>
    </message>
    <message>
        <source>Rotate the light</source>
        <translation>Licht drehen</translation>
    </message>
    <message>
        <source>Hold Ctrl</source>
        <translation>Strg gedrückt halten</translation>
    </message>
    <message>
        <source>Ten times finer</source>
        <translation>Zehnmal feiner</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>About {program}</source>
        <translation>Über {program}</translation>
    </message>
    <message>
        <source>Design the appearance of automotive paint and see it, while editing,&lt;br&gt;on a car-like surface in a real environment.</source>
        <translation>Das Aussehen von Autolack gestalten und beim Bearbeiten sehen,&lt;br&gt;auf einer Karosserieform in einer wirklichen Umgebung.</translation>
    </message>
    <message>
        <source>Apache License 2.0. Qt {version} under the LGPL.</source>
        <translation>Apache-Lizenz 2.0. Qt {version} unter der LGPL.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>&amp;Lack</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Tafeln</translation>
    </message>
    <message>
        <source>Show or Hide P&amp;anels</source>
        <translation>T&amp;afeln zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Find a &amp;Command…</source>
        <translation>&amp;Befehl suchen …</translation>
    </message>
    <message>
        <source>Keyboard &amp;Shortcuts</source>
        <translation>Tasten&amp;kürzel</translation>
    </message>
    <message>
        <source>&amp;About BRDF Suite</source>
        <translation>&amp;Über BRDF Suite</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>Ganzer &amp;Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>{file}, at {place}</source>
        <translation>{file}, bei {place}</translation>
    </message>
    <message>
        <source>Internal error: {fault}</source>
        <translation>Interner Fehler: {fault}</translation>
    </message>
    <message>
        <source>Your document is unchanged; save it. The log has the details.</source>
        <translation>Das Dokument ist unverändert; es sollte gesichert werden. Das Protokoll nennt die Einzelheiten.</translation>
    </message>
    <message>
        <source>Show the whole message</source>
        <translation>Ganze Meldung zeigen</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Dark (L* 20)</source>
        <translation>Dunkel (L* 20)</translation>
    </message>
    <message>
        <source>Booth (L* 50)</source>
        <translation>Lichtkabine (L* 50)</translation>
    </message>
    <message>
        <source>Light (L* 85)</source>
        <translation>Hell (L* 85)</translation>
    </message>
    <message>
        <source>Follow the system</source>
        <translation>Systemvorgabe</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Umfeld</translation>
    </message>
    <message>
        <source>L*, C* and h over the aspecular angle</source>
        <translation>L*, C* und h über dem Aspekularwinkel</translation>
    </message>
    <message>
        <source>L*, C*, h over the angle</source>
        <translation>L*, C*, h über dem Winkel</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>L*, C* and h: lines of the last paint that can be</source>
        <translation>L*, C* und h: Linien des letzten möglichen Lacks</translation>
    </message>
    <message>
        <source>Lines of the last paint that can be</source>
        <translation>Linien des letzten möglichen Lacks</translation>
    </message>
    <message>
        <source>Earlier lines</source>
        <translation>Frühere Linien</translation>
    </message>
    <message>
        <source>Points are what is asked at the measured angles; drag one up or down to change it.</source>
        <translation>Die Punkte sind das an den gemessenen Winkeln Verlangte; einer lässt sich nach oben oder unten ziehen.</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>fitted lobes</source>
        <translation>angepasste Keulen</translation>
    </message>
    <message>
        <source>Show the plot of {name}</source>
        <translation>Diagramm von {name} zeigen</translation>
    </message>
    <message>
        <source>The paint that was open is unchanged.</source>
        <translation>Der offene Lack ist unverändert.</translation>
    </message>
    <message>
        <source>Viewer could not be started.</source>
        <translation>Viewer konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>Start it by hand: brdf-viewer.</source>
        <translation>Von Hand starten: brdf-viewer.</translation>
    </message>
    <message>
        <source>Refractive index n of the clearcoat: the higher, the more it mirrors; resins have 1.45 to 1.55. Setting it sets both gloss readings.</source>
        <translation>Brechzahl n des Klarlacks: je höher, desto mehr spiegelt er; Harze haben 1,45 bis 1,55. Sie setzt beide Glanzwerte.</translation>
    </message>
    <message>
        <source>Roughness α of the clearcoat: spread of its facets&apos; slopes (Beckmann). 0.003 is a fresh car, 0.05 satin. Setting it sets both gloss readings.</source>
        <translation>Rauheit α des Klarlacks: Streuung der Neigungen seiner Facetten (Beckmann). 0.003 ist ein neues Auto, 0.05 seidenmatt. Sie setzt beide Glanzwerte.</translation>
    </message>
    <message>
        <source>Haze index: gloss at 60° minus gloss at 20° (as practice reads ASTM D4039), GU. It grows where light is scattered just beside the mirror direction, so that a glossy coat looks milky; a smooth clear coat has about 5 to 12.</source>
        <translation>Haze-Index: Glanz bei 60° minus Glanz bei 20° (wie ASTM D4039 in der Praxis gelesen wird), GU. Er wächst, wo Licht dicht neben die Spiegelrichtung gestreut wird, sodass ein glänzender Lack milchig aussieht; ein glatter Klarlack hat etwa 5 bis 12.</translation>
    </message>
    <message>
        <source>Root mean square slope of the waves; a tenth of a degree is seen at arm&apos;s length.</source>
        <translation>Quadratisches Mittel der Wellenneigung; ein Zehntelgrad sieht man auf Armlänge.</translation>
    </message>
    <message>
        <source>A 60° reading is known</source>
        <translation>Ein 60°-Wert ist bekannt</translation>
    </message>
    <message>
        <source>With both readings the refractive index is solved too; otherwise it is 1.5, or what 20° needs.</source>
        <translation>Mit beiden Werten wird auch die Brechzahl bestimmt; sonst ist sie 1,5 oder was 20° braucht.</translation>
    </message>
    <message>
        <source>Index n</source>
        <translation>Brechzahl n</translation>
    </message>
    <message>
        <source>Roughness of the coat</source>
        <translation>Rauheit des Klarlacks</translation>
    </message>
    <message>
        <source>Roughness α</source>
        <translation>Rauheit α</translation>
    </message>
    <message>
        <source>Haze</source>
        <translation>Haze</translation>
    </message>
    <message>
        <source>Orange peel</source>
        <translation>Orangenhaut</translation>
    </message>
    <message>
        <source>Waviness of the coat, as sprayed coats have it. Viewer draws it, and a view may set its own instead.</source>
        <translation>Welligkeit des Klarlacks, wie gespritzte Lacke sie haben. Viewer zeichnet sie; eine Ansicht kann statt ihrer eine eigene setzen.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>from the readings</source>
        <translation>aus den Messwerten</translation>
    </message>
    <message>
        <source>{slope:.3f}° RMS, computed</source>
        <translation>{slope:.3f}° RMS, berechnet</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>–, no such coat</source>
        <translation>–, kein solcher Klarlack</translation>
    </message>
    <message>
        <source>{haze:.1f} GU, {source}</source>
        <translation>{haze:.1f} GU, {source}</translation>
    </message>
    <message>
        <source>A coat of n {ior:.3f} and α {roughness:.4f} reads the same at 20 and 60°; the readings are what the paint keeps, and the coat nearest to n 1.5 is taken.</source>
        <translation>Ein Klarlack mit n {ior:.3f} und α {roughness:.4f} hat dieselben Werte bei 20 und 60°; der Lack behält die Messwerte, und genommen wird der Klarlack, der n 1,5 am nächsten ist.</translation>
    </message>
    <message>
        <source>Edit &amp;One Angle</source>
        <translation>&amp;Einen Winkel ändern</translation>
    </message>
    <message>
        <source>Edit &amp;All Angles Together</source>
        <translation>&amp;Alle Winkel zusammen ändern</translation>
    </message>
    <message>
        <source>Edit the &amp;Flop</source>
        <translation>Den &amp;Flop ändern</translation>
    </message>
    <message>
        <source>Colours in &amp;L*a*b*</source>
        <translation>Farben in &amp;L*a*b*</translation>
    </message>
    <message>
        <source>Colours in LC&amp;h</source>
        <translation>Farben in LC&amp;h</translation>
    </message>
    <message>
        <source>Angles: &amp;3 (15, 45, 110°)</source>
        <translation>Winkel: &amp;3 (15, 45, 110°)</translation>
    </message>
    <message>
        <source>Angles: &amp;5 (15 to 110°)</source>
        <translation>Winkel: &amp;5 (15 bis 110°)</translation>
    </message>
    <message>
        <source>Angles: &amp;6 (−15 to 110°)</source>
        <translation>Winkel: &amp;6 (−15 bis 110°)</translation>
    </message>
    <message>
        <source>Angles: &amp;8, Two Lights (E2539)</source>
        <translation>Winkel: &amp;8, zwei Lichter (E2539)</translation>
    </message>
    <message>
        <source>Type the &amp;Numbers</source>
        <translation>&amp;Zahlen eintippen</translation>
    </message>
    <message>
        <source>3 angles: 15, 45, 110°</source>
        <translation>3 Winkel: 15, 45, 110°</translation>
    </message>
    <message>
        <source>5 angles: 15, 25, 45, 75, 110°</source>
        <translation>5 Winkel: 15, 25, 45, 75, 110°</translation>
    </message>
    <message>
        <source>6 angles: −15, 15, 25, 45, 75, 110°</source>
        <translation>6 Winkel: −15, 15, 25, 45, 75, 110°</translation>
    </message>
    <message>
        <source>8 geometries, two lights (E2539)</source>
        <translation>8 Geometrien, zwei Lichter (E2539)</translation>
    </message>
    <message>
        <source>Own angles</source>
        <translation>Eigene Winkel</translation>
    </message>
    <message>
        <source>The aspecular angles at which the colour is given. Another set takes the colours that the paint has at the new angles, so that it keeps its look.</source>
        <translation>Die Aspekularwinkel, an denen die Farbe angegeben ist. Ein anderer Satz nimmt die Farben, die der Lack an den neuen Winkeln hat, sodass er sein Aussehen behält.</translation>
    </message>
    <message>
        <source>L*a*b*</source>
        <translation>L*a*b*</translation>
    </message>
    <message>
        <source>Lightness, green to red, blue to yellow (CIE 1976, D65, 10°).</source>
        <translation>Helligkeit, grün bis rot, blau bis gelb (CIE 1976, D65, 10°).</translation>
    </message>
    <message>
        <source>LCh°</source>
        <translation>LCh°</translation>
    </message>
    <message>
        <source>Lightness, chroma and hue angle (CIE 1976, D65, 10°).</source>
        <translation>Helligkeit, Buntheit und Bunttonwinkel (CIE 1976, D65, 10°).</translation>
    </message>
    <message>
        <source>One angle</source>
        <translation>Ein Winkel</translation>
    </message>
    <message>
        <source>An edit changes the colour at its own angle alone.</source>
        <translation>Eine Änderung gilt nur der Farbe am eigenen Winkel.</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>Face and flop move in step: what an edit adds at one angle is added at every angle.</source>
        <translation>Aufsicht und Flop bewegen sich gemeinsam: Was an einem Winkel dazukommt, kommt an jedem dazu.</translation>
    </message>
    <message>
        <source>Flop</source>
        <translation>Flop</translation>
    </message>
    <message>
        <source>Flop: how the colour changes from the view near the mirror direction to the shallow one. The face (45°) stays, and the angles on either side of it move.</source>
        <translation>Flop: wie sich die Farbe vom Blick nahe der Spiegelrichtung zum flachen Blick ändert. Die Aufsicht (45°) bleibt, die Winkel zu beiden Seiten bewegen sich.</translation>
    </message>
    <message>
        <source>New angle</source>
        <translation>Neuer Winkel</translation>
    </message>
    <message>
        <source>Add angle</source>
        <translation>Winkel hinzufügen</translation>
    </message>
    <message>
        <source>Add a reading at this angle, with the colour that the paint has there.</source>
        <translation>Einen Wert an diesem Winkel hinzufügen, mit der Farbe, die der Lack dort hat.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Further</source>
        <translation>Weiterer</translation>
    </message>
    <message>
        <source>Colours in</source>
        <translation>Farben in</translation>
    </message>
    <message>
        <source>An edit moves</source>
        <translation>Eine Änderung bewegt</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Aspecular angle of a further reading, with the light at {light:g}°.</source>
        <translation>Aspekularwinkel eines weiteren Werts, mit dem Licht bei {light:g}°.</translation>
    </message>
    <message>
        <source>No such paint can be.</source>
        <translation>Einen solchen Lack kann es nicht geben.</translation>
    </message>
    <message>
        <source>No sum of the lobes gives the colour asked at {angles}.</source>
        <translation>Keine Summe der Keulen ergibt die bei {angles} verlangte Farbe.</translation>
    </message>
    <message>
        <source>No paint near to it was found that can be; change a colour or the gloss.</source>
        <translation>In der Nähe wurde kein möglicher Lack gefunden; eine Farbe oder den Glanz ändern.</translation>
    </message>
    <message>
        <source>The nearest that can be: {paint}.</source>
        <translation>Der nächste mögliche: {paint}.</translation>
    </message>
    <message>
        <source>Take the Nearest</source>
        <translation>Den nächsten nehmen</translation>
    </message>
    <message>
        <source>The nearest paint that can be was not found: {error}</source>
        <translation>Der nächste mögliche Lack wurde nicht gefunden: {error}</translation>
    </message>
    <message>
        <source>gloss {gu:g} GU at 20°</source>
        <translation>Glanz {gu:g} GU bei 20°</translation>
    </message>
    <message>
        <source>gloss {gu_20:g} GU at 20° and {gu_60:g} GU at 60°</source>
        <translation>Glanz {gu_20:g} GU bei 20° und {gu_60:g} GU bei 60°</translation>
    </message>
    <message>
        <source>{angle}: {lab} (ΔE00 {error:.1f})</source>
        <translation>{angle}: {lab} (ΔE00 {error:.1f})</translation>
    </message>
    <message>
        <source>Lightness L* (CIE 1976, D65, 10°). A perfect white diffuser has 100; a metallic may pass it near the mirror direction.</source>
        <translation>Helligkeit L* (CIE 1976, D65, 10°). Ein vollkommen weißer Streuer hat 100; ein Metallic kann nahe der Spiegelrichtung darüber liegen.</translation>
    </message>
    <message>
        <source>a*: from green (negative) to red (positive).</source>
        <translation>a*: von Grün (negativ) bis Rot (positiv).</translation>
    </message>
    <message>
        <source>b*: from blue (negative) to yellow (positive).</source>
        <translation>b*: von Blau (negativ) bis Gelb (positiv).</translation>
    </message>
    <message>
        <source>Chroma C*ab: how far the colour is from grey, the distance from 0 in the plane of a* and b*.</source>
        <translation>Buntheit C*ab: wie weit die Farbe von Grau entfernt ist, der Abstand von 0 in der Ebene von a* und b*.</translation>
    </message>
    <message>
        <source>Hue angle hab: 0° red, 90° yellow, 180° green, 270° blue; the circle closes. A grey has no hue: then this is the hue that it gets as soon as it has chroma.</source>
        <translation>Bunttonwinkel hab: 0° Rot, 90° Gelb, 180° Grün, 270° Blau; der Kreis schließt sich. Ein Grau hat keinen Buntton: Dann ist dies der, den es bekommt, sobald es Buntheit hat.</translation>
    </message>
    <message>
        <source>Pick the colour at {angle}</source>
        <translation>Farbe bei {angle} wählen</translation>
    </message>
    <message>
        <source>{name} at {angle}</source>
        <translation>{name} bei {angle}</translation>
    </message>
    <message>
        <source>{name}, number</source>
        <translation>{name}, Zahl</translation>
    </message>
    <message>
        <source>The angle from the mirror direction of the light to the view, past the normal: the aspecular angle.</source>
        <translation>Der Winkel von der Spiegelrichtung des Lichts zum Blick, an der Normalen vorbei: der Aspekularwinkel.</translation>
    </message>
    <message>
        <source>Remove the reading at {angle}</source>
        <translation>Wert bei {angle} entfernen</translation>
    </message>
    <message>
        <source>The paint keeps its last valid value.</source>
        <translation>Der Lack behält seinen letzten gültigen Wert.</translation>
    </message>
    <message>
        <source>Take Roughness {roughness:.4f}</source>
        <translation>Rauheit {roughness:.4f} nehmen</translation>
    </message>
    <message>
        <source>The numbers keep your edit; curve, strip and the other programs show the last paint that can be.</source>
        <translation>Die Zahlen behalten die Änderung; Kurve, Streifen und die anderen Programme zeigen den letzten möglichen Lack.</translation>
    </message>
    <message>
        <source>The paint cannot be told to the other programs: {reason}.</source>
        <translation>Der Lack kann den anderen Programmen nicht gesagt werden: {reason}.</translation>
    </message>
    <message>
        <source>They keep the paint before.</source>
        <translation>Sie behalten den Lack davor.</translation>
    </message>
    <message>
        <source>Change {name} at {angle}</source>
        <translation>{name} bei {angle} ändern</translation>
    </message>
    <message>
        <source>Change {name} at All Angles</source>
        <translation>{name} an allen Winkeln ändern</translation>
    </message>
    <message>
        <source>Pick Colour at {angle}</source>
        <translation>Farbe bei {angle} wählen</translation>
    </message>
    <message>
        <source>Change {name}</source>
        <translation>{name} ändern</translation>
    </message>
    <message>
        <source>A coat that rough mirrors {share:.4f} of the light at {angle:g}° by itself, and the colour there is darker. With index {ior:.3f} its roughness can be up to {most:.4f}.</source>
        <translation>Ein so rauer Klarlack spiegelt bei {angle:g}° allein {share:.4f} des Lichts, und die Farbe dort ist dunkler. Mit der Brechzahl {ior:.3f} kann seine Rauheit bis {most:.4f} gehen.</translation>
    </message>
    <message>
        <source>Change Flop Index</source>
        <translation>Flop-Index ändern</translation>
    </message>
    <message>
        <source>Change Lightness Travel</source>
        <translation>Helligkeitsweg ändern</translation>
    </message>
    <message>
        <source>Change Chroma Travel</source>
        <translation>Buntheitsweg ändern</translation>
    </message>
    <message>
        <source>Change Hue Travel</source>
        <translation>Bunttonweg ändern</translation>
    </message>
    <message>
        <source>Change Angles</source>
        <translation>Winkel ändern</translation>
    </message>
    <message>
        <source>Add Angle</source>
        <translation>Winkel hinzufügen</translation>
    </message>
    <message>
        <source>Remove Angle</source>
        <translation>Winkel entfernen</translation>
    </message>
    <message>
        <source>Change Index of the Coat</source>
        <translation>Brechzahl des Klarlacks ändern</translation>
    </message>
    <message>
        <source>Change Roughness of the Coat</source>
        <translation>Rauheit des Klarlacks ändern</translation>
    </message>
    <message>
        <source>Switch Orange Peel</source>
        <translation>Orangenhaut ein oder aus</translation>
    </message>
    <message>
        <source>Switch Flakes</source>
        <translation>Flakes ein oder aus</translation>
    </message>
    <message>
        <source>Make Solid</source>
        <translation>Uni machen</translation>
    </message>
    <message>
        <source>Take Nearest Paint</source>
        <translation>Nächsten Lack nehmen</translation>
    </message>
    <message>
        <source>Change Interpolation</source>
        <translation>Interpolation ändern</translation>
    </message>
    <message>
        <source>Change Near-Specular Factor</source>
        <translation>Faktor nahe der Spiegelrichtung ändern</translation>
    </message>
    <message>
        <source>Rename Paint</source>
        <translation>Lack umbenennen</translation>
    </message>
    <message>
        <source>Edit Notes</source>
        <translation>Notizen ändern</translation>
    </message>
    <message>
        <source>Edit Source</source>
        <translation>Herkunft ändern</translation>
    </message>
    <message>
        <source>Viewer draws these flakes one by one in the brightest lights; the mean colour stays that of the readings.</source>
        <translation>Viewer zeichnet diese Flakes einzeln in den hellsten Lichtern; die mittlere Farbe bleibt die der Messwerte.</translation>
    </message>
    <message>
        <source>Our own sparkle figure, from the model of the flakes: spots per mm² that are brighter than the surface around them by {contrast:.0%} or more, and the mean of how much brighter they are (contrast); in the sun 45° off the normal, seen from {distance:g} mm by an eye that takes in {resolved:.3f} mm. It is no instrument&apos;s reading and must not be compared with one.</source>
        <translation>Unser eigenes Glitzermaß, aus dem Modell der Flakes: Punkte je mm², die um {contrast:.0%} oder mehr heller sind als die Fläche um sie, und wie viel heller sie im Mittel sind (Kontrast); in der Sonne 45° neben der Normalen, aus {distance:g} mm gesehen von einem Auge, das {resolved:.3f} mm auflöst. Es ist kein Messwert eines Geräts und mit keinem zu vergleichen.</translation>
    </message>
    <message>
        <source>Flakes that can be seen</source>
        <translation>Sichtbare Flakes</translation>
    </message>
    <message>
        <source>Sparkle {angle:g}°</source>
        <translation>Glitzern {angle:g}°</translation>
    </message>
    <message>
        <source>no spots</source>
        <translation>keine Punkte</translation>
    </message>
    <message>
        <source>grain: spots run together</source>
        <translation>Körnung: Punkte laufen zusammen</translation>
    </message>
    <message>
        <source>{spots:.2f} spots/mm², contrast {contrast:.1f}</source>
        <translation>{spots:.2f} Punkte/mm², Kontrast {contrast:.1f}</translation>
    </message>
    <message>
        <source>Flop index</source>
        <translation>Flop-Index</translation>
    </message>
    <message>
        <source>Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high flop. It needs readings at 15, 45 and 110°.</source>
        <translation>Flop-Index 2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop. Er braucht Werte bei 15, 45 und 110°.</translation>
    </message>
    <message>
        <source>ΔL* travel</source>
        <translation>ΔL*-Weg</translation>
    </message>
    <message>
        <source>Travel of lightness: L* at the farthest angle minus L* at the nearest. Negative: the paint darkens.</source>
        <translation>Helligkeitsweg: L* am fernsten Winkel minus L* am nächsten. Negativ: Der Lack wird dunkler.</translation>
    </message>
    <message>
        <source>ΔC* travel</source>
        <translation>ΔC*-Weg</translation>
    </message>
    <message>
        <source>Travel of chroma: C* at the farthest angle minus C* at the nearest. Negative: the paint greys.</source>
        <translation>Buntheitsweg: C* am fernsten Winkel minus C* am nächsten. Negativ: Der Lack vergraut.</translation>
    </message>
    <message>
        <source>Δh travel</source>
        <translation>Δh-Weg</translation>
    </message>
    <message>
        <source>Travel of hue: by how many degrees it turns from the nearest to the farthest angle; positive from red towards yellow. A grey has no hue to travel.</source>
        <translation>Bunttonweg: um wie viel Grad sich der Buntton vom nächsten zum fernsten Winkel dreht; positiv von Rot nach Gelb. Ein Grau hat keinen Buntton.</translation>
    </message>
    <message>
        <source>{name}, slider</source>
        <translation>{name}, Regler</translation>
    </message>
    <message>
        <source>No flop: {reason}.</source>
        <translation>Kein Flop: {reason}.</translation>
    </message>
    <message>
        <source>From {near:g}° to {far:g}°; the colour at {face:g}° stays.</source>
        <translation>Von {near:g}° bis {far:g}°; die Farbe bei {face:g}° bleibt.</translation>
    </message>
    <message>
        <source>Hand-over</source>
        <translation>Übergabe</translation>
    </message>
    <message>
        <source>&amp;Hand Over…</source>
        <translation>Über&amp;geben …</translation>
    </message>
    <message>
        <source>Export the paint for other programs, or make a report of it</source>
        <translation>Den Lack für andere Programme ausgeben oder einen Bericht machen</translation>
    </message>
    <message>
        <source>Session (session.json)</source>
        <translation>Sitzung (session.json)</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>The session that was open is unchanged.</source>
        <translation>Die geöffnete Sitzung ist unverändert.</translation>
    </message>
    <message>
        <source>{positions} × {exposures} photographs</source>
        <translation>{positions} × {exposures} Fotos</translation>
    </message>
    <message>
        <source>None of the photographs of this position can be read.</source>
        <translation>Keines der Fotos dieser Stellung ist lesbar.</translation>
    </message>
    <message>
        <source>session.json keeps what it had.</source>
        <translation>session.json behält, was sie hatte.</translation>
    </message>
    <message>
        <source>session.json was changed by another program since it was opened here.</source>
        <translation>session.json wurde von einem anderen Programm geändert, seit sie hier geöffnet ist.</translation>
    </message>
    <message>
        <source>Check Again reads it; then edit once more.</source>
        <translation>Erneut prüfen liest sie; danach noch einmal ändern.</translation>
    </message>
    <message>
        <source>With dark frames</source>
        <translation>Mit Dunkelbildern</translation>
    </message>
    <message>
        <source>With a white reference</source>
        <translation>Mit Weißreferenz</translation>
    </message>
    <message>
        <source>With a flat field</source>
        <translation>Mit Weißbild</translation>
    </message>
    <message>
        <source>With {count} photographs of a board</source>
        <translation>Mit {count} Fotos einer Kalibriertafel</translation>
    </message>
    <message>
        <source>Reading {folder}</source>
        <translation>{folder} wird gelesen</translation>
    </message>
    <message>
        <source>Exporting {name}</source>
        <translation>{name} wird ausgegeben</translation>
    </message>
    <message>
        <source>{name} was written.</source>
        <translation>{name} wurde geschrieben.</translation>
    </message>
    <message>
        <source>An older file of that name is unchanged.</source>
        <translation>Eine ältere Datei dieses Namens ist unverändert.</translation>
    </message>
    <message>
        <source>CxF3, one specification per angle</source>
        <translation>CxF3, eine Spezifikation je Winkel</translation>
    </message>
    <message>
        <source>CSV table, one row per paint</source>
        <translation>CSV-Tabelle, eine Zeile je Lack</translation>
    </message>
    <message>
        <source>JSON, with computed values</source>
        <translation>JSON, mit berechneten Werten</translation>
    </message>
    <message>
        <source>LuxCore car paint</source>
        <translation>LuxCore, Autolack</translation>
    </message>
    <message>
        <source>MaterialX, OpenPBR surface</source>
        <translation>MaterialX, OpenPBR-Oberfläche</translation>
    </message>
    <message>
        <source>glTF, clearcoat</source>
        <translation>glTF, Klarlack</translation>
    </message>
    <message>
        <source>RGL measured material</source>
        <translation>RGL, gemessenes Material</translation>
    </message>
    <message>
        <source>Report, HTML</source>
        <translation>Bericht, HTML</translation>
    </message>
    <message>
        <source>Report, PDF</source>
        <translation>Bericht, PDF</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The kind of file; what it cannot hold of this paint stands below</source>
        <translation>Die Art der Datei; was sie von diesem Lack nicht fasst, steht darunter</translation>
    </message>
    <message>
        <source>What the format holds</source>
        <translation>Was das Format fasst</translation>
    </message>
    <message>
        <source>What the format loses</source>
        <translation>Was das Format verliert</translation>
    </message>
    <message>
        <source>With pictures</source>
        <translation>Mit Bildern</translation>
    </message>
    <message>
        <source>The speed form in the booth and a sphere in the sun, by the real renderer</source>
        <translation>Die Speedform in der Lichtkabine und eine Kugel in der Sonne, vom wirklichen Renderer</translation>
    </message>
    <message>
        <source>Against the standard</source>
        <translation>Gegen den Bezug</translation>
    </message>
    <message>
        <source>Differences, words and tolerances of the section Standard go into the report</source>
        <translation>Abstände, Worte und Toleranzen des Abschnitts „Bezug“ kommen in den Bericht</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Ausgeben …</translation>
    </message>
    <message>
        <source>Write the paint as it is now into a file of this format</source>
        <translation>Den Lack, wie er jetzt ist, in eine Datei dieses Formats schreiben</translation>
    </message>
    <message>
        <source>Finding out what is lost…</source>
        <translation>Es wird ermittelt, was verloren geht …</translation>
    </message>
    <message>
        <source>Nothing is lost.</source>
        <translation>Nichts geht verloren.</translation>
    </message>
    <message>
        <source>Lost:</source>
        <translation>Verloren:</translation>
    </message>
    <message>
        <source>&amp;History Strip</source>
        <translation>&amp;Verlaufsstreifen</translation>
    </message>
    <message>
        <source>Show or hide the states of this paint</source>
        <translation>Zustände dieses Lacks zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Go to This State</source>
        <translation>Zu diesem Zustand &amp;gehen</translation>
    </message>
    <message>
        <source>&amp;Take It as a New Step</source>
        <translation>Als neuen Schritt über&amp;nehmen</translation>
    </message>
    <message>
        <source>Take Earlier State</source>
        <translation>Früheren Zustand nehmen</translation>
    </message>
    <message>
        <source>&amp;Open It in a New Tab</source>
        <translation>In neuem Reiter &amp;öffnen</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>State {number}: {step}</source>
        <translation>Zustand {number}: {step}</translation>
    </message>
    <message>
        <source>{state}, the paint as it is now</source>
        <translation>{state}, der Lack, wie er jetzt ist</translation>
    </message>
    <message>
        <source>{state}, undone</source>
        <translation>{state}, zurückgenommen</translation>
    </message>
    <message>
        <source>History of this paint</source>
        <translation>Verlauf dieses Lacks</translation>
    </message>
    <message>
        <source>Every state of this paint, the oldest at the left; click one to go back to it.</source>
        <translation>Jeder Zustand dieses Lacks, der älteste links; ein Klick geht zu ihm zurück.</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <translation>Interpolieren</translation>
    </message>
    <message>
        <source>Choose another paint for the other end.</source>
        <translation>Für das andere Ende einen anderen Lack wählen.</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei …</translation>
    </message>
    <message>
        <source>{name}, from a file…</source>
        <translation>{name}, aus einer Datei …</translation>
    </message>
    <message>
        <source>Paints and measured files ({patterns})</source>
        <translation>Lacke und Messdateien ({patterns})</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The other paint</source>
        <translation>Der andere Lack</translation>
    </message>
    <message>
        <source>The paint at the other end: an open tab, a shipped paint, or one of a file</source>
        <translation>Der Lack am anderen Ende: ein offener Reiter, ein mitgelieferter Lack oder einer aus einer Datei</translation>
    </message>
    <message>
        <source>Choose the paint at the other end.</source>
        <translation>Den Lack am anderen Ende wählen.</translation>
    </message>
    <message>
        <source>Interpolate to…</source>
        <translation>Interpolieren zu …</translation>
    </message>
    <message>
        <source>Click to take the paint at {percent:.0f} %</source>
        <translation>Klick nimmt den Lack bei {percent:.0f} %</translation>
    </message>
    <message>
        <source>Share of the other paint, %</source>
        <translation>Anteil des anderen Lacks, %</translation>
    </message>
    <message>
        <source>Share of the other paint</source>
        <translation>Anteil des anderen Lacks</translation>
    </message>
    <message>
        <source>Where the mixture lies: 0 % is this paint, 100 % the other one</source>
        <translation>Wo die Mischung liegt: 0 % ist dieser Lack, 100 % der andere</translation>
    </message>
    <message>
        <source>Beyond the ends</source>
        <translation>Über die Enden hinaus</translation>
    </message>
    <message>
        <source>From −50 to 150 %: away from the other paint, or past it</source>
        <translation>Von −50 bis 150 %: vom anderen Lack weg oder an ihm vorbei</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>New from &amp;Measurement…</source>
        <translation>Neu aus &amp;Messung …</translation>
    </message>
    <message>
        <source>Measure a reflectance by the virtual spectrophotometer and design from there</source>
        <translation>Eine Reflexion mit dem virtuellen Spektralfotometer messen und von dort aus gestalten</translation>
    </message>
    <message>
        <source>Measured files and paints ({patterns})</source>
        <translation>Messdateien und Lacke ({patterns})</translation>
    </message>
    <message>
        <source>The paints that are open are unchanged.</source>
        <translation>Die offenen Lacke sind unverändert.</translation>
    </message>
    <message>
        <source>{name} holds {count} paints; the first {opened} are open.</source>
        <translation>{name} enthält {count} Lacke; die ersten {opened} sind offen.</translation>
    </message>
    <message>
        <source>Measure Again</source>
        <translation>Erneut messen</translation>
    </message>
    <message>
        <source>Read at</source>
        <translation>Gelesen bei</translation>
    </message>
    <message>
        <source>The angles of the design; another set reads the original again</source>
        <translation>Die Winkel des Entwurfs; ein anderer Satz liest das Original erneut</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>light {angle:g}°</source>
        <translation>Licht {angle:g}°</translation>
    </message>
    <message>
        <source>ΔE00 between the design and the original</source>
        <translation>ΔE00 zwischen Entwurf und Original</translation>
    </message>
    <message>
        <source>ΔE00 between the design and the original at angles that it was not made from</source>
        <translation>ΔE00 zwischen Entwurf und Original an Winkeln, aus denen er nicht gemacht ist</translation>
    </message>
    <message>
        <source>Original as Standard</source>
        <translation>Original als Bezug</translation>
    </message>
    <message>
        <source>Judge the design against what was measured, at every angle</source>
        <translation>Den Entwurf an jedem Winkel gegen das Gemessene beurteilen</translation>
    </message>
    <message>
        <source>Glossmeter: no reading; {gloss:g} GU at 20° is set, not measured</source>
        <translation>Glanzmesser: kein Wert; {gloss:g} GU bei 20° ist gesetzt, nicht gemessen</translation>
    </message>
    <message>
        <source>Glossmeter: {readings}</source>
        <translation>Glanzmesser: {readings}</translation>
    </message>
    <message>
        <source>Glossmeter: {readings}; {gloss:g} GU at 20° is set instead</source>
        <translation>Glanzmesser: {readings}; statt dessen ist {gloss:g} GU bei 20° gesetzt</translation>
    </message>
    <message>
        <source>The design cannot be compared with the original yet: no such paint can be built.</source>
        <translation>Der Entwurf lässt sich noch nicht mit dem Original vergleichen: Einen solchen Lack kann es nicht geben.</translation>
    </message>
    <message>
        <source>ΔE00 to the original at {count} angles that were not used: mean {mean:.1f}, at most {worst:.1f} ({angle:g}°, light {light:g}°)</source>
        <translation>ΔE00 zum Original an {count} nicht benutzten Winkeln: Mittel {mean:.1f}, höchstens {worst:.1f} ({angle:g}°, Licht {light:g}°)</translation>
    </message>
    <message>
        <source>Gloss 20°</source>
        <translation>Glanz 20°</translation>
    </message>
    <message>
        <source>Gloss 60°</source>
        <translation>Glanz 60°</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Wavelength</source>
        <translation>Wellenlänge</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Colour spread</source>
        <translation>Farbstreuung</translation>
    </message>
    <message>
        <source>Near-specular</source>
        <translation>Nahe Spiegelrichtung</translation>
    </message>
    <message>
        <source>Gloss units at 20° (ASTM D523, ISO 2813): polished black glass of index 1.567 reads 100. Coat and base together. The narrow 20° receptor tells glossy coats apart.</source>
        <translation>Glanzeinheiten bei 20° (ASTM D523, ISO 2813): poliertes schwarzes Glas der Brechzahl 1,567 hat 100. Klarlack und Basis zusammen. Der schmale 20°-Empfänger unterscheidet glänzende Lacke.</translation>
    </message>
    <message>
        <source>Gloss units at 60°, coat and base together: the wide receptor, for coats of every gloss. With both readings index and roughness of the coat are solved.</source>
        <translation>Glanzeinheiten bei 60°, Klarlack und Basis zusammen: der weite Empfänger, für Lacke jeden Glanzes. Mit beiden Werten werden Brechzahl und Rauheit des Klarlacks bestimmt.</translation>
    </message>
    <message>
        <source>Root mean square height of the coat&apos;s waviness, µm. A good finish has some tenths of a micrometre.</source>
        <translation>Quadratisches Mittel der Wellenhöhe des Klarlacks, µm. Eine gute Lackierung hat einige Zehntel Mikrometer.</translation>
    </message>
    <message>
        <source>Typical distance from crest to crest, mm. Waves of 1 to 10 mm are seen from arm&apos;s length as orange peel; they blur the edges of what is mirrored, which lowers the distinctness of image (DOI).</source>
        <translation>Üblicher Abstand von Kamm zu Kamm, mm. Wellen von 1 bis 10 mm sieht man auf Armlänge als Orangenhaut; sie verwischen die Kanten des Gespiegelten und mindern die Abbildungsschärfe (DOI).</translation>
    </message>
    <message>
        <source>How many flakes of a square millimetre can be seen one by one; most flakes of a paint lie too deep for that.</source>
        <translation>Wie viele Flakes eines Quadratmillimeters einzeln zu sehen sind; die meisten Flakes eines Lacks liegen dafür zu tief.</translation>
    </message>
    <message>
        <source>Mean diameter of a flake, µm; larger flakes are brighter and sparkle more coarsely.</source>
        <translation>Mittlerer Durchmesser eines Flakes, µm; größere Flakes sind heller und glitzern gröber.</translation>
    </message>
    <message>
        <source>Spread of the flakes&apos; tilts, as the root mean square slope m: about 0.15 to 0.19 for metallic paints. Wider spreads sparkle at more angles, and less at each.</source>
        <translation>Streuung der Flake-Neigungen, als quadratisches Mittel der Steigung m: etwa 0.15 bis 0.19 für Metalliclacke. Breitere Streuung glitzert an mehr Winkeln und an jedem weniger.</translation>
    </message>
    <message>
        <source>How differently the flakes are coloured: 0 all alike, 1 every hue.</source>
        <translation>Wie verschieden die Flakes gefärbt sind: 0 alle gleich, 1 jeder Buntton.</translation>
    </message>
    <message>
        <source>Scales the base in the mirror direction, where no instrument looks; not measured.</source>
        <translation>Skaliert die Basis in der Spiegelrichtung, in die kein Gerät blickt; nicht gemessen.</translation>
    </message>
    <message>
        <source>Flake tilts (bell)</source>
        <translation>Flake-Neigungen (Glocke)</translation>
    </message>
    <message>
        <source>Monotone (PCHIP)</source>
        <translation>Monoton (PCHIP)</translation>
    </message>
    <message>
        <source>Polynomial (2nd order)</source>
        <translation>Polynom (2. Grades)</translation>
    </message>
    <message>
        <source>Between angles</source>
        <translation>Zwischen Winkeln</translation>
    </message>
    <message>
        <source>The rule between the measured angles: a bell of flake tilts, a monotone curve through L*a*b*, or a parabola.</source>
        <translation>Die Regel zwischen den gemessenen Winkeln: eine Glocke von Flake-Neigungen, eine monotone Kurve durch L*a*b* oder eine Parabel.</translation>
    </message>
    <message>
        <source>Not measured: no instrument of three angles looks below 15°.</source>
        <translation>Nicht gemessen: Kein Gerät mit drei Winkeln blickt unter 15°.</translation>
    </message>
    <message>
        <source>Not measured: no reading lies nearer to the mirror direction than {angle:g}°.</source>
        <translation>Nicht gemessen: Kein Wert liegt näher an der Spiegelrichtung als {angle:g}°.</translation>
    </message>
    <message>
        <source>Sphere radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Camera distance</source>
        <translation>Kameraabstand</translation>
    </message>
    <message>
        <source>Camera height</source>
        <translation>Kamerahöhe</translation>
    </message>
    <message>
        <source>Camera tilt</source>
        <translation>Kameraneigung</translation>
    </message>
    <message>
        <source>Of the optical axis, positive upwards</source>
        <translation>Der optischen Achse, nach oben positiv</translation>
    </message>
    <message>
        <source>Lamp distance</source>
        <translation>Lampenabstand</translation>
    </message>
    <message>
        <source>Lamp height</source>
        <translation>Lampenhöhe</translation>
    </message>
    <message>
        <source>Angle offset</source>
        <translation>Winkelversatz</translation>
    </message>
    <message>
        <source>A known error of the turntable&apos;s zero, added to every stated angle</source>
        <translation>Ein bekannter Fehler der Null des Drehtellers; kommt zu jedem angegebenen Winkel hinzu</translation>
    </message>
    <message>
        <source>A folder with photographs of the painted sphere and a session.json that describes them.</source>
        <translation>Ein Ordner mit Fotos der lackierten Kugel und einer session.json, die sie beschreibt.</translation>
    </message>
    <message>
        <source>A photograph of the session</source>
        <translation>Ein Foto der Sitzung</translation>
    </message>
    <message>
        <source>Problems of the session</source>
        <translation>Mängel der Sitzung</translation>
    </message>
    <message>
        <source>Open Folder…</source>
        <translation>Ordner öffnen …</translation>
    </message>
    <message>
        <source>Open a folder that has a session.json</source>
        <translation>Einen Ordner mit einer session.json öffnen</translation>
    </message>
    <message>
        <source>New Folder…</source>
        <translation>Neuer Ordner …</translation>
    </message>
    <message>
        <source>Make a folder with a session.json to fill in, for photographs to come</source>
        <translation>Einen Ordner mit einer session.json zum Ausfüllen anlegen, für künftige Fotos</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Check Again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Look at every photograph of the folder once more</source>
        <translation>Jedes Foto des Ordners noch einmal ansehen</translation>
    </message>
    <message>
        <source>What is changed here is written to session.json at once; Ctrl+Z takes it back.</source>
        <translation>Was hier geändert wird, steht sofort in session.json; Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>What the session holds</source>
        <translation>Was die Sitzung enthält</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>No folder is open.</source>
        <translation>Kein Ordner ist geöffnet.</translation>
    </message>
    <message>
        <source>Open a folder of photographs, or make a new one: its session.json tells what to photograph.</source>
        <translation>Öffnen Sie einen Ordner mit Fotos oder legen Sie einen neuen an: Seine session.json sagt, was zu fotografieren ist.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>As session.json has it</source>
        <translation>Wie es in session.json steht</translation>
    </message>
    <message>
        <source>{count}, {first:g} to {last:g}°</source>
        <translation>{count}, {first:g} bis {last:g}°</translation>
    </message>
    <message>
        <source>Angles of the lamp; 0° is in front of the camera</source>
        <translation>Winkel der Lampe; 0° ist vor der Kamera</translation>
    </message>
    <message>
        <source>Exposures</source>
        <translation>Belichtungen</translation>
    </message>
    <message>
        <source>{count}, {short:g} to {long:g} ms</source>
        <translation>{count}, {short:g} bis {long:g} ms</translation>
    </message>
    <message>
        <source>Of every position, shortest first</source>
        <translation>Jeder Stellung, die kürzeste zuerst</translation>
    </message>
    <message>
        <source>{bits} bits, response: {response}</source>
        <translation>{bits} Bit, Kennlinie: {response}</translation>
    </message>
    <message>
        <source>What the numbers of a pixel mean</source>
        <translation>Was die Zahlen eines Pixels bedeuten</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Errors: {count}. What they name must be put right, or is left out.</source>
        <translation>Fehler: {count}. Was sie nennen, ist zu berichtigen oder bleibt außen vor.</translation>
    </message>
    <message>
        <source>No errors. To know: {count}.</source>
        <translation>Keine Fehler. Zu wissen: {count}.</translation>
    </message>
    <message>
        <source>{count} photographs looked at; nothing is wrong.</source>
        <translation>{count} Fotos angesehen; nichts ist falsch.</translation>
    </message>
    <message>
        <source>What a check found, the file it is about, and why</source>
        <translation>Was eine Prüfung fand, welche Datei es betrifft und warum</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>What the paint is called</source>
        <translation>Wie der Lack heißt</translation>
    </message>
    <message>
        <source>Where the readings come from</source>
        <translation>Woher die Messwerte kommen</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Of a code</source>
        <translation>Eines Codes</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>The code without light, per channel</source>
        <translation>Der Code ohne Licht, je Kanal</translation>
    </message>
    <message>
        <source>Trusted</source>
        <translation>Verlässlich</translation>
    </message>
    <message>
        <source>codes {low} to {high}</source>
        <translation>Codes {low} bis {high}</translation>
    </message>
    <message>
        <source>Codes between which the response was measured in every channel</source>
        <translation>Codes, zwischen denen die Kennlinie in jedem Kanal gemessen wurde</translation>
    </message>
    <message>
        <source>Read noise</source>
        <translation>Ausleserauschen</translation>
    </message>
    <message>
        <source>Standard deviation in the dark, of the full scale of a linear camera</source>
        <translation>Standardabweichung im Dunkeln, bezogen auf den Vollausschlag einer linearen Kamera</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>within {worst:.2f} %</source>
        <translation>auf {worst:.2f} %</translation>
    </message>
    <message>
        <source>Largest difference between a stated exposure time and what the photographs say</source>
        <translation>Größter Unterschied zwischen einer angegebenen Belichtungszeit und dem, was die Fotos sagen</translation>
    </message>
    <message>
        <source>From linear</source>
        <translation>Von linear</translation>
    </message>
    <message>
        <source>RMS distance of the curve from a straight line, in the logarithm of the exposure</source>
        <translation>Mittlerer quadratischer Abstand der Kurve von einer Geraden, im Logarithmus der Belichtung</translation>
    </message>
    <message>
        <source>That took part</source>
        <translation>Die mitgewirkt haben</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Until nothing changed any more</source>
        <translation>Bis sich nichts mehr änderte</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>{rms:.3f} px RMS</source>
        <translation>{rms:.3f} px quadr. Mittel</translation>
    </message>
    <message>
        <source>Root mean square distance of the edge that was seen from the outline that was fitted</source>
        <translation>Mittlerer quadratischer Abstand des gesehenen Randes vom angepassten Umriss</translation>
    </message>
    <message>
        <source>Highlights</source>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>{px:.3f} px, {deg:.4f}° RMS</source>
        <translation>{px:.3f} px, {deg:.4f}° quadr. Mittel</translation>
    </message>
    <message>
        <source>What is left between found and expected highlights after the refinement</source>
        <translation>Was zwischen gefundenen und erwarteten Glanzlichtern nach der Verfeinerung bleibt</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>The same with the numbers of session.json</source>
        <translation>Dasselbe mit den Zahlen der session.json</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Verwendet</translation>
    </message>
    <message>
        <source>{used} of {count} highlights</source>
        <translation>{used} von {count} Glanzlichtern</translation>
    </message>
    <message>
        <source>The others do not belong: a second reflection, or the arm</source>
        <translation>Die anderen gehören nicht dazu: eine zweite Spiegelung oder der Arm</translation>
    </message>
    <message>
        <source>Middle of its outline, column and row</source>
        <translation>Mitte ihres Umrisses, Spalte und Zeile</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>{distance:.1f} mm</source>
        <translation>{distance:.1f} mm</translation>
    </message>
    <message>
        <source>From the camera to the centre of the sphere</source>
        <translation>Von der Kamera zum Kugelmittelpunkt</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Distance of the board&apos;s corners from where the calibrated camera expects them</source>
        <translation>Abstand der Ecken der Kalibriertafel von dort, wo die kalibrierte Kamera sie erwartet</translation>
    </message>
    <message>
        <source>{value} ± {sigma}
stated {stated}</source>
        <translation>{value} ± {sigma}
angegeben {stated}</translation>
    </message>
    <message>
        <source>The highlights tell {share:.0f} % of it: {why}</source>
        <translation>Die Glanzlichter sagen {share:.0f} % davon: {why}</translation>
    </message>
    <message>
        <source>drawing the coverage</source>
        <translation>Abdeckung wird gezeichnet</translation>
    </message>
    <message>
        <source>{share:.1f} %</source>
        <translation>{share:.1f} %</translation>
    </message>
    <message>
        <source>Of the bins with light and view up to 75° from the normal; the others are filled from neighbours</source>
        <translation>Der Zellen mit Licht und Blick bis 75° von der Normalen; die übrigen sind aus Nachbarn gefüllt</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Pixels that went into the table</source>
        <translation>Pixel, die in die Tabelle eingingen</translation>
    </message>
    <message>
        <source>Of the lamp</source>
        <translation>Der Lampe</translation>
    </message>
    <message>
        <source>Illuminant and observer of all L*a*b* values</source>
        <translation>Lichtart und Beobachter aller L*a*b*-Werte</translation>
    </message>
    <message>
        <source>{illuminant}, {observer}° observer</source>
        <translation>{illuminant}, {observer}°-Beobachter</translation>
    </message>
    <message>
        <source>Small Pict&amp;ure</source>
        <translation>Kleines &amp;Bild</translation>
    </message>
    <message>
        <source>Show or hide the paint on the speed form</source>
        <translation>Lack auf der Speedform zeigen oder verbergen</translation>
    </message>
    <message>
        <source>The picture stays as it was.</source>
        <translation>Das Bild bleibt, wie es war.</translation>
    </message>
    <message>
        <source>The paint on the speed form</source>
        <translation>Der Lack auf der Speedform</translation>
    </message>
    <message>
        <source>Light booth</source>
        <translation>Lichtkabine</translation>
    </message>
    <message>
        <source>Sunny</source>
        <translation>Sonnig</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>The paint on the speed form, drawn by the same renderer as in Viewer. Drag to orbit, wheel to zoom, Alt drag (or right drag) to turn the light, F to frame.</source>
        <translation>Der Lack auf der Speedform, gezeichnet wie in Viewer. Ziehen umkreist, Mausrad zoomt, Ziehen mit Alt (oder rechts) dreht das Licht, F rahmt ein.</translation>
    </message>
    <message>
        <source>Light of the small picture</source>
        <translation>Licht des kleinen Bildes</translation>
    </message>
    <message>
        <source>The light in which the small picture shows the paint</source>
        <translation>Das Licht, in dem das kleine Bild den Lack zeigt</translation>
    </message>
    <message>
        <source>Speed form: of the last paint that can be</source>
        <translation>Speedform: vom letzten möglichen Lack</translation>
    </message>
    <message>
        <source>Speed form (earlier)</source>
        <translation>Speedform (früher)</translation>
    </message>
    <message>
        <source>On the speed form</source>
        <translation>Auf der Speedform</translation>
    </message>
    <message>
        <source>Speed form</source>
        <translation>Speedform</translation>
    </message>
    <message>
        <source>No picture here: this screen has no OpenGL. The numbers, patches and curves are complete; Viewer on another computer can show the paint by its file.</source>
        <translation>Hier kein Bild: Dieser Bildschirm hat kein OpenGL. Zahlen, Felder und Kurven sind vollständig; Viewer auf einem anderen Rechner kann den Lack aus seiner Datei zeigen.</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>L*</source>
        <translation>L*</translation>
    </message>
    <message>
        <source>Lightness L* over the aspecular angle.</source>
        <translation>Helligkeit L* über dem Aspekularwinkel.</translation>
    </message>
    <message>
        <source>Chroma</source>
        <translation>Buntheit</translation>
    </message>
    <message>
        <source>C*</source>
        <translation>C*</translation>
    </message>
    <message>
        <source>Chroma C*ab over the aspecular angle.</source>
        <translation>Buntheit C*ab über dem Aspekularwinkel.</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Buntton</translation>
    </message>
    <message>
        <source>h (°)</source>
        <translation>h (°)</translation>
    </message>
    <message>
        <source>Hue angle hab over the aspecular angle, unwrapped; a grey has none and no point.</source>
        <translation>Bunttonwinkel hab über dem Aspekularwinkel, stetig fortgesetzt; ein Grau hat keinen und keinen Punkt.</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>A grey has no hue.</source>
        <translation>Ein Grau hat keinen Buntton.</translation>
    </message>
    <message>
        <source>{name} over the aspecular angle</source>
        <translation>{name} über dem Aspekularwinkel</translation>
    </message>
    <message>
        <source>Drag a point, or choose one with Left and Right and move it with Up and Down (Shift: finely).</source>
        <translation>Einen Punkt ziehen, oder mit Links und Rechts wählen und mit Auf und Ab bewegen (Umschalt: fein).</translation>
    </message>
    <message>
        <source>Aspecular angle (degrees)</source>
        <translation>Aspekularwinkel (Grad)</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>State of {time}</source>
        <translation>Zustand von {time}</translation>
    </message>
    <message>
        <source>Nothing was swapped.</source>
        <translation>Nichts wurde getauscht.</translation>
    </message>
    <message>
        <source>Swapped with {name}</source>
        <translation>Getauscht mit {name}</translation>
    </message>
    <message>
        <source>Swap with Standard</source>
        <translation>Mit Bezug tauschen</translation>
    </message>
    <message>
        <source>{file} has changed.</source>
        <translation>{file} hat sich geändert.</translation>
    </message>
    <message>
        <source>{file} can no longer be read.</source>
        <translation>{file} ist nicht mehr lesbar.</translation>
    </message>
    <message>
        <source>The standard stays as it was; load the file again to take what it has now.</source>
        <translation>Der Bezug bleibt, wie er war; die Datei neu laden, um zu nehmen, was sie jetzt enthält.</translation>
    </message>
    <message>
        <source>Standards ({patterns})</source>
        <translation>Bezüge ({patterns})</translation>
    </message>
    <message>
        <source>Some paints cannot be judged: {reasons}</source>
        <translation>Manche Lacke lassen sich nicht beurteilen: {reasons}</translation>
    </message>
    <message>
        <source>Use This State as &amp;Standard</source>
        <translation>Diesen Zustand als &amp;Bezug nehmen</translation>
    </message>
    <message>
        <source>&amp;Load Standard…</source>
        <translation>Bezug &amp;laden …</translation>
    </message>
    <message>
        <source>S&amp;wap with Standard</source>
        <translation>Mit Bezug &amp;tauschen</translation>
    </message>
    <message>
        <source>&amp;Remove Standard</source>
        <translation>Bezug &amp;entfernen</translation>
    </message>
    <message>
        <source>CIEDE2000</source>
        <translation>CIEDE2000</translation>
    </message>
    <message>
        <source>CMC (2:1), acceptability</source>
        <translation>CMC (2:1), Annehmbarkeit</translation>
    </message>
    <message>
        <source>CMC (1:1), perceptibility</source>
        <translation>CMC (1:1), Wahrnehmbarkeit</translation>
    </message>
    <message>
        <source>CMC (l:c), weights of your own</source>
        <translation>CMC (l:c), eigene Gewichte</translation>
    </message>
    <message>
        <source>CAM02-UCS</source>
        <translation>CAM02-UCS</translation>
    </message>
    <message>
        <source>CIELAB ΔE*ab</source>
        <translation>CIELAB ΔE*ab</translation>
    </message>
    <message>
        <source>No standard. Take the present state as one, or load a paint, a palette, CxF3 or a measured BRDF; what you edit is then the batch that is judged against it.</source>
        <translation>Kein Bezug. Den jetzigen Zustand nehmen, oder einen Lack, eine Palette, CxF3 oder eine gemessene BRDF laden; was bearbeitet wird, ist dann die Probe, die gegen ihn beurteilt wird.</translation>
    </message>
    <message>
        <source>This State</source>
        <translation>Dieser Zustand</translation>
    </message>
    <message>
        <source>Take the present state as the standard</source>
        <translation>Den jetzigen Zustand als Bezug nehmen</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>An open tab, a shipped paint, or a file: paint, palette, CxF3, measured BRDF</source>
        <translation>Ein offener Reiter, ein mitgelieferter Lack oder eine Datei: Lack, Palette, CxF3, gemessene BRDF</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Edit the standard, and judge it against what is edited now</source>
        <translation>Den Bezug bearbeiten und gegen das jetzt Bearbeitete beurteilen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Judge against nothing</source>
        <translation>Gegen nichts beurteilen</translation>
    </message>
    <message>
        <source>From a &amp;File…</source>
        <translation>Aus einer &amp;Datei …</translation>
    </message>
    <message>
        <source>Open tabs</source>
        <translation>Offene Reiter</translation>
    </message>
    <message>
        <source>&amp;Shipped Paint</source>
        <translation>&amp;Mitgelieferter Lack</translation>
    </message>
    <message>
        <source>The paint against which the one in front is judged; the file has several</source>
        <translation>Der Lack, gegen den der vordere beurteilt wird; die Datei hat mehrere</translation>
    </message>
    <message>
        <source>Differences in words</source>
        <translation>Unterschiede in Worten</translation>
    </message>
    <message>
        <source>Batch minus standard at each aspecular angle, and whether it is within the tolerance there</source>
        <translation>Probe minus Bezug an jedem Aspekularwinkel, und ob sie dort in der Toleranz liegt</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>The formula of ΔE, and of its tolerances</source>
        <translation>Die Formel von ΔE und seinen Toleranzen</translation>
    </message>
    <message>
        <source>Weight l of the lightness</source>
        <translation>Gewicht l der Helligkeit</translation>
    </message>
    <message>
        <source>Weight c of the chroma</source>
        <translation>Gewicht c der Buntheit</translation>
    </message>
    <message>
        <source>CMC(l:c) divides the difference of lightness by l and that of chroma by c</source>
        <translation>CMC(l:c) teilt den Helligkeitsabstand durch l und den Buntheitsabstand durch c</translation>
    </message>
    <message>
        <source>A larger weight lets a larger difference pass</source>
        <translation>Ein größeres Gewicht lässt einen größeren Abstand durch</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>What may differ at each aspecular angle, in units of the formula above</source>
        <translation>Was an jedem Aspekularwinkel abweichen darf, in Einheiten der Formel darüber</translation>
    </message>
    <message>
        <source>ΔL*, ΔC*, ΔH* as one ellipsoid</source>
        <translation>ΔL*, ΔC*, ΔH* als ein Ellipsoid</translation>
    </message>
    <message>
        <source>Judge the three parts together, their tolerances being the half axes; else each alone</source>
        <translation>Die drei Teile zusammen beurteilen, ihre Toleranzen als Halbachsen; sonst jeden einzeln</translation>
    </message>
    <message>
        <source>Batches</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Paints against this standard; Return or a double click opens one</source>
        <translation>Lacke gegen diesen Bezug; Eingabe oder Doppelklick öffnet einen</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Judge further paints against this standard</source>
        <translation>Weitere Lacke gegen diesen Bezug beurteilen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Take away the paints that were added; the tabs stay</source>
        <translation>Die hinzugefügten Lacke wegnehmen; die Reiter bleiben</translation>
    </message>
    <message>
        <source>ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>SCHLECHT</translation>
    </message>
    <message>
        <source>Nothing to compare: no angle in common</source>
        <translation>Nichts zu vergleichen: kein gemeinsamer Winkel</translation>
    </message>
    <message>
        <source>{verdict}: {difference} up to {largest:.2f}, mean {mean:.2f}</source>
        <translation>{verdict}: {difference} bis {largest:.2f}, Mittel {mean:.2f}</translation>
    </message>
    <message>
        <source>flop index {standard:.1f} → {batch:.1f}</source>
        <translation>Flop-Index {standard:.1f} → {batch:.1f}</translation>
    </message>
    <message>
        <source>gloss {angle}° {change} GU</source>
        <translation>Glanz {angle}° {change} GU</translation>
    </message>
    <message>
        <source>standard: no reading</source>
        <translation>Bezug: kein Wert</translation>
    </message>
    <message>
        <source>The standard has no reading here.</source>
        <translation>Der Bezug hat hier keinen Wert.</translation>
    </message>
    <message>
        <source>Beyond the tolerance: {parts}</source>
        <translation>Außerhalb der Toleranz: {parts}</translation>
    </message>
    <message>
        <source>Standard L*a*b* {lab}</source>
        <translation>Bezug L*a*b* {lab}</translation>
    </message>
    <message>
        <source>* Read from the standard&apos;s reflectance by the virtual spectrophotometer.</source>
        <translation>* Mit dem virtuellen Spektralfotometer aus der Reflexion des Bezugs gelesen.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Differences from the standard per angle</source>
        <translation>Abstände vom Bezug je Winkel</translation>
    </message>
    <message>
        <source>all angles</source>
        <translation>alle Winkel</translation>
    </message>
    <message>
        <source>Tolerances per angle</source>
        <translation>Toleranzen je Winkel</translation>
    </message>
    <message>
        <source>Largest size of {part} that passes; empty: not judged</source>
        <translation>Größter Betrag von {part}, der durchgeht; leer: nicht beurteilt</translation>
    </message>
    <message>
        <source>“{text}” is no tolerance; write a number from 0, or nothing.</source>
        <translation>„{text}“ ist keine Toleranz; eine Zahl ab 0 schreiben oder nichts.</translation>
    </message>
    <message>
        <source>Batches against the standard</source>
        <translation>Proben gegen den Bezug</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>ΔE max</source>
        <translation>ΔE max</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>lighter</source>
        <translation>heller</translation>
    </message>
    <message>
        <source>darker</source>
        <translation>dunkler</translation>
    </message>
    <message>
        <source>cleaner</source>
        <translation>reiner</translation>
    </message>
    <message>
        <source>dirtier</source>
        <translation>schmutziger</translation>
    </message>
    <message>
        <source>redder</source>
        <translation>röter</translation>
    </message>
    <message>
        <source>yellower</source>
        <translation>gelber</translation>
    </message>
    <message>
        <source>greener</source>
        <translation>grüner</translation>
    </message>
    <message>
        <source>bluer</source>
        <translation>blauer</translation>
    </message>
    <message>
        <source>more flop</source>
        <translation>mehr Flop</translation>
    </message>
    <message>
        <source>less flop</source>
        <translation>weniger Flop</translation>
    </message>
    <message>
        <source>slightly {word}</source>
        <translation>etwas {word}</translation>
    </message>
    <message>
        <source>much {word}</source>
        <translation>viel {word}</translation>
    </message>
    <message>
        <source>{first} and {second}</source>
        <translation>{first} und {second}</translation>
    </message>
    <message>
        <source>{first}, {second}</source>
        <translation>{first}, {second}</translation>
    </message>
    <message>
        <source>{first}; {second}</source>
        <translation>{first}; {second}</translation>
    </message>
    <message>
        <source>{words} at {angles}</source>
        <translation>{words} bei {angles}</translation>
    </message>
    <message>
        <source>{words} at every angle</source>
        <translation>{words} an jedem Winkel</translation>
    </message>
    <message>
        <source>no visible difference</source>
        <translation>kein sichtbarer Unterschied</translation>
    </message>
    <message>
        <source>Flop: how much darker the paint is from the face to the flop, as the index
2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high flop.
First what is asked, then what the fitted lobes reach.</source>
        <translation>Flop: um wie viel dunkler der Lack von der Aufsicht zum Flop wird, als Index
2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop.
Zuerst das Verlangte, dann was die angepassten Keulen erreichen.</translation>
    </message>
    <message>
        <source>The largest colour difference CIEDE2000 between what is asked and what the fitted lobes give: at the measured angles, and between them; then the time from the paint to its weights, and whether they are exact or the best at the time limit.</source>
        <translation>Der größte Farbabstand CIEDE2000 zwischen dem Verlangten und dem, was die angepassten Keulen ergeben: an den gemessenen Winkeln und zwischen ihnen; dann die Zeit vom Lack zu seinen Gewichten, und ob sie genau sind oder die besten am Zeitlimit.</translation>
    </message>
    <message>
        <source>Whether this screen, taken as sRGB, can show the measured colours.</source>
        <translation>Ob dieser Bildschirm, als sRGB angenommen, die gemessenen Farben zeigen kann.</translation>
    </message>
    <message>
        <source>Programs that follow this paint while it is edited.</source>
        <translation>Programme, die diesem Lack beim Bearbeiten folgen.</translation>
    </message>
    <message>
        <source>Outside sRGB: {angles}</source>
        <translation>Außerhalb von sRGB: {angles}</translation>
    </message>
    <message>
        <source>In sRGB</source>
        <translation>In sRGB</translation>
    </message>
    <message>
        <source>Fit ΔE00 ≤ {worst}, between ≤ {between}, {time} ms, {kind}</source>
        <translation>Anpassung ΔE00 ≤ {worst}, dazwischen ≤ {between}, {time} ms, {kind}</translation>
    </message>
    <message>
        <source>time-limited</source>
        <translation>Zeitlimit</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>No fit</source>
        <translation>Keine Anpassung</translation>
    </message>
    <message>
        <source>This is of the last paint that can be.</source>
        <translation>Dies ist vom letzten möglichen Lack.</translation>
    </message>
    <message>
        <source>Linked: {programs}</source>
        <translation>Verbunden: {programs}</translation>
    </message>
    <message>
        <source>Not linked</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Flop –</source>
        <translation>Flop –</translation>
    </message>
    <message>
        <source>The flop index needs readings at 15, 45 and 110°.</source>
        <translation>Der Flop-Index braucht Werte bei 15, 45 und 110°.</translation>
    </message>
    <message>
        <source>Flop {asked}</source>
        <translation>Flop {asked}</translation>
    </message>
    <message>
        <source>{flop}, reached {reached}</source>
        <translation>{flop}, erreicht {reached}</translation>
    </message>
    <message>
        <source>{angle}: asked {asked}, fit {given}, ΔE00 {difference}</source>
        <translation>{angle}: verlangt {asked}, Anpassung {given}, ΔE00 {difference}</translation>
    </message>
    <message>
        <source>The process that draws the small pictures ended twice.</source>
        <translation>Der Prozess, der die kleinen Bilder zeichnet, endete zweimal.</translation>
    </message>
    <message>
        <source>The small pictures cannot be drawn: {reason}.</source>
        <translation>Die kleinen Bilder können nicht gezeichnet werden: {reason}.</translation>
    </message>
    <message>
        <source>Lighter</source>
        <translation>Heller</translation>
    </message>
    <message>
        <source>Darker</source>
        <translation>Dunkler</translation>
    </message>
    <message>
        <source>Cleaner</source>
        <translation>Reiner</translation>
    </message>
    <message>
        <source>Dirtier</source>
        <translation>Schmutziger</translation>
    </message>
    <message>
        <source>More Flop</source>
        <translation>Mehr Flop</translation>
    </message>
    <message>
        <source>Less Flop</source>
        <translation>Weniger Flop</translation>
    </message>
    <message>
        <source>Redder</source>
        <translation>Röter</translation>
    </message>
    <message>
        <source>Yellower</source>
        <translation>Gelber</translation>
    </message>
    <message>
        <source>Greener</source>
        <translation>Grüner</translation>
    </message>
    <message>
        <source>Bluer</source>
        <translation>Blauer</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>{reason} The discs show the readings instead.</source>
        <translation>{reason} Statt ihrer zeigen die Scheiben die Messwerte.</translation>
    </message>
    <message>
        <source>{word}: none</source>
        <translation>{word}: keine</translation>
    </message>
    <message>
        <source>No paint of this kind quite gives these colours: ΔE00 {missed:.1f} at most. L*a*b*:</source>
        <translation>Kein Lack dieser Art ergibt ganz diese Farben: höchstens ΔE00 {missed:.1f}. L*a*b*:</translation>
    </message>
    <message>
        <source>Click to take it. L*a*b*:</source>
        <translation>Klick übernimmt. L*a*b*:</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>present</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>The paint as it is now, among its neighbours</source>
        <translation>Der Lack, wie er jetzt ist, unter seinen Nachbarn</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Distance of the neighbours in ΔL*, ΔC* or ΔH*, about as in ΔE*ab</source>
        <translation>Abstand der Nachbarn in ΔL*, ΔC* oder ΔH*, ungefähr wie in ΔE*ab</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>The light of the small pictures</source>
        <translation>Das Licht der kleinen Bilder</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>What the small pictures show the paint on</source>
        <translation>Worauf die kleinen Bilder den Lack zeigen</translation>
    </message>
    <message>
        <source>Colour at {angle}</source>
        <translation>Farbe bei {angle}</translation>
    </message>
    <message>
        <source>&amp;Pick Colour</source>
        <translation>Farbe &amp;wählen</translation>
    </message>
    <message>
        <source>Make S&amp;olid From</source>
        <translation>&amp;Uni machen aus</translation>
    </message>
    <message>
        <source>At {angle}…</source>
        <translation>Bei {angle} …</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Section {title}</source>
        <translation>Abschnitt {title}</translation>
    </message>
    <message>
        <source>Ac&amp;quire…</source>
        <translation>Auf&amp;nehmen …</translation>
    </message>
    <message>
        <source>From photographs of a painted sphere to a paint, step by step</source>
        <translation>Von Fotos einer lackierten Kugel zum Lack, Schritt für Schritt</translation>
    </message>
    <message>
        <source>The table over the half vector: θh from the normal, θd between light and half vector. Hatched: filled from neighbours.</source>
        <translation>Die Tabelle über dem Halbvektor: θh von der Normalen, θd zwischen Licht und Halbvektor. Schraffiert: aus Nachbarn gefüllt.</translation>
    </message>
    <message>
        <source>Coverage of the table</source>
        <translation>Abdeckung der Tabelle</translation>
    </message>
    <message>
        <source>Share of the φd bins measured</source>
        <translation>Anteil der gemessenen φd-Zellen</translation>
    </message>
    <message>
        <source>Pixels in them</source>
        <translation>Pixel darin</translation>
    </message>
    <message>
        <source>Relative standard error</source>
        <translation>Relativer Standardfehler</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Was die Karte zeigt</translation>
    </message>
    <message>
        <source>What the grey of a cell means</source>
        <translation>Was das Grau einer Zelle bedeutet</translation>
    </message>
    <message>
        <source>The cell under the cursor</source>
        <translation>Die Zelle unter dem Zeiger</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>The table</source>
        <translation>Die Tabelle</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Save Table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>As .brdftable with its coverage, or as .binary in the MERL layout</source>
        <translation>Als .brdftable mit ihrer Abdeckung oder als .binary in der MERL-Anordnung</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>There is no table yet: the step before makes it.</source>
        <translation>Es gibt noch keine Tabelle: Der Schritt davor macht sie.</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>θh and θd under the cursor</source>
        <translation>θh und θd unter dem Zeiger</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Share of its φd bins</source>
        <translation>Anteil ihrer φd-Zellen</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>That fell into it</source>
        <translation>Die hineinfielen</translation>
    </message>
    <message>
        <source>Relative standard error of the mean</source>
        <translation>Relativer Standardfehler des Mittels</translation>
    </message>
    <message>
        <source>φd bins measured (%)</source>
        <translation>φd-Zellen gemessen (%)</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>relative standard error (%)</source>
        <translation>relativer Standardfehler (%)</translation>
    </message>
    <message>
        <source>θh (degrees)</source>
        <translation>θh (Grad)</translation>
    </message>
    <message>
        <source>θd (degrees)</source>
        <translation>θd (Grad)</translation>
    </message>
    <message>
        <source>Each position was photographed with several exposures: the highlight needs a short, the flank a long one.</source>
        <translation>Jede Stellung wurde mehrfach belichtet: Das Glanzlicht braucht eine kurze, die Flanke eine lange Zeit.</translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation>Das Foto</translation>
    </message>
    <message>
        <source>Open a session first.</source>
        <translation>Öffnen Sie zuerst eine Sitzung.</translation>
    </message>
    <message>
        <source>Photographs of this position</source>
        <translation>Fotos dieser Stellung</translation>
    </message>
    <message>
        <source>Exposure time, and the share of clipped pixels, which are hatched; Left and Right choose</source>
        <translation>Belichtungszeit und Anteil übersteuerter Pixel, die schraffiert sind; Links und Rechts wählen</translation>
    </message>
    <message>
        <source>Histogram of the photograph</source>
        <translation>Histogramm des Fotos</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Problems of this position</source>
        <translation>Mängel dieser Stellung</translation>
    </message>
    <message>
        <source>Position of the lamp</source>
        <translation>Stellung der Lampe</translation>
    </message>
    <message>
        <source>Which position&apos;s photographs are shown</source>
        <translation>Die Fotos welcher Stellung gezeigt werden</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Of the picture on the screen alone, in stops</source>
        <translation>Nur des Bildes auf dem Schirm, in Blenden</translation>
    </message>
    <message>
        <source>The pixel under the cursor</source>
        <translation>Das Pixel unter dem Zeiger</translation>
    </message>
    <message>
        <source>Exposure times and clipped pixels</source>
        <translation>Belichtungszeiten und übersteuerte Pixel</translation>
    </message>
    <message>
        <source>Time, ms</source>
        <translation>Zeit, ms</translation>
    </message>
    <message>
        <source>EXIF, ms</source>
        <translation>EXIF, ms</translation>
    </message>
    <message>
        <source>Clipped</source>
        <translation>Überst.</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Stated in session.json; in the file (EXIF); share of pixels clipped in a channel; share within the noise</source>
        <translation>In session.json angegeben; in der Datei (EXIF); Anteil der Pixel, die in einem Kanal übersteuert sind; Anteil im Rauschen</translation>
    </message>
    <message>
        <source>Exposure Times</source>
        <translation>Belichtungszeiten</translation>
    </message>
    <message>
        <source>Under the Cursor</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>No photograph of this position can be read; the session&apos;s page tells why.</source>
        <translation>Kein Foto dieser Stellung ist lesbar; die Seite der Sitzung sagt, warum.</translation>
    </message>
    <message>
        <source>{time:.4g} ms
{clipped}</source>
        <translation>{time:.4g} ms
{clipped}</translation>
    </message>
    <message>
        <source>The files hold no times of their own; the stated ones are taken.</source>
        <translation>Die Dateien nennen keine eigenen Zeiten; die angegebenen gelten.</translation>
    </message>
    <message>
        <source>{count} files tell another time than session.json.</source>
        <translation>{count} Dateien nennen eine andere Zeit als session.json.</translation>
    </message>
    <message>
        <source>The times in the files are the stated ones.</source>
        <translation>Die Zeiten in den Dateien sind die angegebenen.</translation>
    </message>
    <message>
        <source>Lamp at {angle:g}°, position {number} of {count}</source>
        <translation>Lampe bei {angle:g}°, Stellung {number} von {count}</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>übersteuert</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grün</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Column and row under the cursor</source>
        <translation>Spalte und Zeile unter dem Zeiger</translation>
    </message>
    <message>
        <source>Codes</source>
        <translation>Codes</translation>
    </message>
    <message>
        <source>Red, green and blue as the file has them</source>
        <translation>Rot, Grün und Blau, wie sie in der Datei stehen</translation>
    </message>
    <message>
        <source>Paint (*.brdfpaint)</source>
        <translation>Lack (*.brdfpaint)</translation>
    </message>
    <message>
        <source>Saved as {file}.</source>
        <translation>Gespeichert als {file}.</translation>
    </message>
    <message>
        <source>“{name}” is open in Designer, in a tab of its own; it is not saved yet.</source>
        <translation>„{name}“ ist in Designer geöffnet, in einem eigenen Reiter; gespeichert ist er noch nicht.</translation>
    </message>
    <message>
        <source>ΔE00 to the fitted lobes at angles that were not used: {mean:.1f} in the mean.</source>
        <translation>ΔE00 zu den angepassten Lappen an nicht verwendeten Winkeln: im Mittel {mean:.1f}.</translation>
    </message>
    <message>
        <source>RMS ln {error:.3f}</source>
        <translation>quadr. Mittel ln {error:.3f}</translation>
    </message>
    <message>
        <source>The sphere&apos;s outline gives its centre; where the highlights lie tells how far the lamp was off.</source>
        <translation>Der Umriss der Kugel gibt ihren Mittelpunkt; wo die Glanzlichter liegen, sagt, wie weit die Lampe daneben war.</translation>
    </message>
    <message>
        <source>Sphere and highlights</source>
        <translation>Kugel und Glanzlichter</translation>
    </message>
    <message>
        <source>Not found yet.</source>
        <translation>Noch nicht gefunden.</translation>
    </message>
    <message>
        <source>What is left between found and expected highlights</source>
        <translation>Was zwischen gefundenen und erwarteten Glanzlichtern bleibt</translation>
    </message>
    <message>
        <source>Lamp angle (degrees)</source>
        <translation>Lampenwinkel (Grad)</translation>
    </message>
    <message>
        <source>Off (pixels)</source>
        <translation>Abstand (Pixel)</translation>
    </message>
    <message>
        <source>Find Sphere and Lamp</source>
        <translation>Kugel und Lampe finden</translation>
    </message>
    <message>
        <source>Find the outline, the highlights of many positions, and what fits them</source>
        <translation>Den Umriss finden, die Glanzlichter vieler Stellungen und was zu ihnen passt</translation>
    </message>
    <message>
        <source>Refine by the highlights</source>
        <translation>Mit den Glanzlichtern verfeinern</translation>
    </message>
    <message>
        <source>Correct the lamp&apos;s angle and height and the sphere&apos;s centre by where the highlights are</source>
        <translation>Winkel und Höhe der Lampe und den Kugelmittelpunkt danach berichtigen, wo die Glanzlichter sind</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>What is left over</source>
        <translation>Was übrig bleibt</translation>
    </message>
    <message>
        <source>Left Over</source>
        <translation>Was übrig bleibt</translation>
    </message>
    <message>
        <source>What was refined</source>
        <translation>Was verfeinert wurde</translation>
    </message>
    <message>
        <source>Refinement</source>
        <translation>Verfeinerung</translation>
    </message>
    <message>
        <source>Magnified</source>
        <translation>Vergrößert</translation>
    </message>
    <message>
        <source>How many times as long the differences are drawn</source>
        <translation>Wievielmal so lang die Unterschiede gezeichnet sind</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>highlights</source>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>outline that was fitted</source>
        <translation>angepasster Umriss</translation>
    </message>
    <message>
        <source>highlight, expected</source>
        <translation>Glanzlicht, erwartet</translation>
    </message>
    <message>
        <source>highlight, found</source>
        <translation>Glanzlicht, gefunden</translation>
    </message>
    <message>
        <source>difference × {gain:g}</source>
        <translation>Unterschied × {gain:g}</translation>
    </message>
    <message>
        <source>edge that was left out</source>
        <translation>ausgelassener Rand</translation>
    </message>
    <message>
        <source>{share:.0f} % of the cells hold something</source>
        <translation>{share:.0f} % der Zellen enthalten etwas</translation>
    </message>
    <message>
        <source>The mask is kept here; the next stroke tries again.</source>
        <translation>Die Maske bleibt hier erhalten; der nächste Strich versucht es erneut.</translation>
    </message>
    <message>
        <source>Nothing is left out. What is painted is kept in the folder as {file}.</source>
        <translation>Nichts ist ausgelassen. Was gemalt wird, kommt als {file} in den Ordner.</translation>
    </message>
    <message>
        <source>Kept in the folder as {file}.</source>
        <translation>Im Ordner als {file}.</translation>
    </message>
    <message>
        <source>everything is used</source>
        <translation>alles wird verwendet</translation>
    </message>
    <message>
        <source>outline of the sphere</source>
        <translation>Umriss der Kugel</translation>
    </message>
    <message>
        <source>Paint over what is not the sphere&apos;s own light: the arm, its reflection, dust. The lower half is left out anyway.</source>
        <translation>Übermalen Sie, was nicht das Licht der Kugel ist: den Arm, seine Spiegelung, Staub. Die untere Hälfte bleibt ohnehin außen vor.</translation>
    </message>
    <message>
        <source>The mask over a photograph</source>
        <translation>Die Maske über einem Foto</translation>
    </message>
    <message>
        <source>Leave Out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Take In</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>The brush leaves pixels out of the measurement (X changes)</source>
        <translation>Der Pinsel lässt Pixel aus der Messung aus (X wechselt)</translation>
    </message>
    <message>
        <source>The brush takes pixels back into the measurement (X changes)</source>
        <translation>Der Pinsel nimmt Pixel wieder in die Messung auf (X wechselt)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of the brush; [ and ] change it over the picture</source>
        <translation>Des Pinsels; [ und ] ändern ihn über dem Bild</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Take the newest stroke back (Ctrl+Z)</source>
        <translation>Den letzten Strich zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wieder</translation>
    </message>
    <message>
        <source>Paint again what was taken back (Ctrl+Shift+Z)</source>
        <translation>Das Zurückgenommene wieder malen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Take In Everything</source>
        <translation>Alles aufnehmen</translation>
    </message>
    <message>
        <source>Begin again with a mask that leaves nothing out</source>
        <translation>Neu beginnen mit einer Maske, die nichts auslässt</translation>
    </message>
    <message>
        <source>The mask</source>
        <translation>Die Maske</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Which position&apos;s photograph lies below the mask</source>
        <translation>Das Foto welcher Stellung unter der Maske liegt</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Share of all pixels of the picture that the mask leaves out</source>
        <translation>Anteil aller Pixel des Bildes, den die Maske auslässt</translation>
    </message>
    <message>
        <source>Lamp at {angle:g}°</source>
        <translation>Lampe bei {angle:g}°</translation>
    </message>
    <message>
        <source>Drag to paint, with Ctrl the other way round; by keys: arrows move the brush, Space paints, [ and ] change its size, X what it does. Wheel zooms, Shift drag moves, F frames.</source>
        <translation>Ziehen malt, mit Strg umgekehrt; mit Tasten: Pfeile bewegen den Pinsel, Leertaste malt, [ und ] ändern seine Größe, X was er tut. Rad zoomt, Ziehen mit Umschalt verschiebt, F rahmt ein.</translation>
    </message>
    <message>
        <source>Wheel, + and − zoom; middle or Shift drag and the arrow keys move; F frames</source>
        <translation>Rad, + und − zoomen; Ziehen mit der Mitte oder Umschalt und die Pfeiltasten verschieben; F rahmt ein</translation>
    </message>
    <message>
        <source>Every photograph becomes measurements of the paint. What is done is kept: it can be stopped and resumed.</source>
        <translation>Aus jedem Foto werden Messwerte des Lacks. Was getan ist, bleibt erhalten: Anhalten und Weitermachen geht jederzeit.</translation>
    </message>
    <message>
        <source>Progress of the reconstruction</source>
        <translation>Fortschritt der Rekonstruktion</translation>
    </message>
    <message>
        <source>Covered so far</source>
        <translation>Bisher abgedeckt</translation>
    </message>
    <message>
        <source>Positions that could not be used</source>
        <translation>Stellungen, die nicht zu verwenden waren</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Turn all photographs into a table of the reflectance</source>
        <translation>Aus allen Fotos eine Tabelle der Reflexion machen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop; what is done is kept, and is gone on with later</source>
        <translation>Anhalten; was getan ist, bleibt erhalten, und es geht später damit weiter</translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Forget what is done, and start with the first position once more</source>
        <translation>Vergessen, was getan ist, und wieder mit der ersten Stellung anfangen</translation>
    </message>
    <message>
        <source>Grazing cut-off</source>
        <translation>Streifgrenze</translation>
    </message>
    <message>
        <source>Light or view farther from the normal than this is not measured</source>
        <translation>Licht oder Blick weiter von der Normalen als dies wird nicht gemessen</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Rekonstruktion</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>Was getan ist</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Getan</translation>
    </message>
    <message>
        <source>Not started.</source>
        <translation>Noch nicht begonnen.</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>{done} of {total}</source>
        <translation>{done} von {total}</translation>
    </message>
    <message>
        <source>Positions of the lamp that are in the table</source>
        <translation>Stellungen der Lampe, die in der Tabelle sind</translation>
    </message>
    <message>
        <source>Positions that could not be used; the list tells why</source>
        <translation>Stellungen, die nicht zu verwenden waren; die Liste sagt, warum</translation>
    </message>
    <message>
        <source>The map grows while positions are done.</source>
        <translation>Die Karte wächst mit jeder Stellung.</translation>
    </message>
    <message>
        <source>The same light with different exposures tells what each code means; the curve is found from all of them.</source>
        <translation>Dasselbe Licht mit verschiedenen Belichtungen sagt, was jeder Code bedeutet; die Kurve wird aus allen gefunden.</translation>
    </message>
    <message>
        <source>Response of the camera</source>
        <translation>Kennlinie der Kamera</translation>
    </message>
    <message>
        <source>Exposure (half at the middle code)</source>
        <translation>Belichtung (½ beim mittleren Code)</translation>
    </message>
    <message>
        <source>Stated exposure times against what the photographs say</source>
        <translation>Angegebene Belichtungszeiten gegen das, was die Fotos sagen</translation>
    </message>
    <message>
        <source>Stated time (ms)</source>
        <translation>Angegebene Zeit (ms)</translation>
    </message>
    <message>
        <source>Difference (%)</source>
        <translation>Unterschied (%)</translation>
    </message>
    <message>
        <source>As session.json says</source>
        <translation>Wie session.json sagt</translation>
    </message>
    <message>
        <source>Linear camera</source>
        <translation>Lineare Kamera</translation>
    </message>
    <message>
        <source>Kind of response</source>
        <translation>Art der Kennlinie</translation>
    </message>
    <message>
        <source>Recovered from the photographs where session.json names no curve; or taken as linear</source>
        <translation>Aus den Fotos ermittelt, wo session.json keine Kurve nennt; oder als linear genommen</translation>
    </message>
    <message>
        <source>Find the Response</source>
        <translation>Kennlinie finden</translation>
    </message>
    <message>
        <source>Find the curve from photographs of several positions</source>
        <translation>Die Kurve aus Fotos mehrerer Stellungen finden</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Kennlinie</translation>
    </message>
    <message>
        <source>How well the curve is known</source>
        <translation>Wie gut die Kurve bekannt ist</translation>
    </message>
    <message>
        <source>How Well It Is Known</source>
        <translation>Wie gut sie bekannt ist</translation>
    </message>
    <message>
        <source>The camera is linear.</source>
        <translation>Die Kamera ist linear.</translation>
    </message>
    <message>
        <source>Codes outside the thick lines are not trusted.</source>
        <translation>Codes außerhalb der dicken Linien gelten nicht als verlässlich.</translation>
    </message>
    <message>
        <source>found less stated</source>
        <translation>gefunden weniger angegeben</translation>
    </message>
    <message>
        <source>The other steps are as they were.</source>
        <translation>Die anderen Schritte sind, wie sie waren.</translation>
    </message>
    <message>
        <source>What is done is kept; Resume goes on with it.</source>
        <translation>Was getan ist, bleibt erhalten; Weiter macht damit weiter.</translation>
    </message>
    <message>
        <source>The mask, the rig or a choice has changed since. Beginning again forgets what it had.</source>
        <translation>Maske, Aufbau oder eine Wahl sind seither anders. Neu beginnen vergisst, was sie hatte.</translation>
    </message>
    <message>
        <source>Table with coverage (*.brdftable)</source>
        <translation>Tabelle mit Abdeckung (*.brdftable)</translation>
    </message>
    <message>
        <source>MERL layout (*.binary)</source>
        <translation>MERL-Anordnung (*.binary)</translation>
    </message>
    <message>
        <source>An earlier reconstruction in this folder cannot be gone on with.</source>
        <translation>Mit einer früheren Rekonstruktion in diesem Ordner geht es nicht weiter.</translation>
    </message>
    <message>
        <source>Begin Again, at the reconstruction, makes a new one.</source>
        <translation>Neu beginnen, bei der Rekonstruktion, macht eine neue.</translation>
    </message>
    <message>
        <source>{done} positions are done from an earlier run.</source>
        <translation>{done} Stellungen sind aus einem früheren Lauf getan.</translation>
    </message>
    <message>
        <source>{done} of {total} done</source>
        <translation>{done} von {total} getan</translation>
    </message>
    <message>
        <source>The photographs are linear files; no curve is needed.</source>
        <translation>Die Fotos sind lineare Dateien; eine Kurve ist unnötig.</translation>
    </message>
    <message>
        <source>Taken from the earlier run; find it again to see it.</source>
        <translation>Aus dem früheren Lauf übernommen; erneut finden zeigt sie.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fertig.</translation>
    </message>
    <message>
        <source>{done} of {total} positions</source>
        <translation>{done} von {total} Stellungen</translation>
    </message>
    <message>
        <source>{share} measured</source>
        <translation>{share} gemessen</translation>
    </message>
    <message>
        <source>Not saved yet; what it was made of is kept in {file}.</source>
        <translation>Noch nicht gespeichert; woraus sie wurde, steht in {file}.</translation>
    </message>
    <message>
        <source>{angle:g}°</source>
        <translation>{angle:g}°</translation>
    </message>
    <message>
        <source>Waiting…</source>
        <translation>Wartet …</translation>
    </message>
    <message>
        <source>Stopped; what is done is kept.</source>
        <translation>Angehalten; was getan ist, bleibt erhalten.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>from the earlier run</source>
        <translation>aus dem früheren Lauf</translation>
    </message>
    <message>
        <source>recovered</source>
        <translation>ermittelt</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>{count} times differ</source>
        <translation>{count} Zeiten weichen ab</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>zu tun</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>getan</translation>
    </message>
    <message>
        <source>look at it</source>
        <translation>ansehen</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>The steps; Alt+1 to Alt+8, Ctrl+PgUp and Ctrl+PgDown go between them</source>
        <translation>Die Schritte; Alt+1 bis Alt+8, Strg+Bild auf und Strg+Bild ab wechseln zwischen ihnen</translation>
    </message>
    <message>
        <source>Alt+{number}</source>
        <translation>Alt+{number}</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The step before (Ctrl+PgUp)</source>
        <translation>Der Schritt davor (Strg+Bild auf)</translation>
    </message>
    <message>
        <source>The step after (Ctrl+PgDown)</source>
        <translation>Der Schritt danach (Strg+Bild ab)</translation>
    </message>
    <message>
        <source>Do All Steps</source>
        <translation>Alle Schritte tun</translation>
    </message>
    <message>
        <source>Response, geometry, reconstruction and fit, one after the other</source>
        <translation>Kennlinie, Geometrie, Rekonstruktion und Anpassung, eins nach dem anderen</translation>
    </message>
    <message>
        <source>Step {number}, {title}: {state}</source>
        <translation>Schritt {number}, {title}: {state}</translation>
    </message>
    <message>
        <source>Acquire: {name}</source>
        <translation>Aufnehmen: {name}</translation>
    </message>
    <message>
        <source>Acquire</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Mean |ln|</source>
        <translation>Mittel |ln|</translation>
    </message>
    <message>
        <source>Mean of |ln(fit/measured)| over every measured bin: the paper&apos;s energy over its number of terms</source>
        <translation>Mittel von |ln(Anpassung/Messung)| über jede gemessene Zelle: die Energie des Aufsatzes durch die Zahl ihrer Glieder</translation>
    </message>
    <message>
        <source>RMS ln</source>
        <translation>quadr. Mittel ln</translation>
    </message>
    <message>
        <source>Root mean square of ln(fit/measured) over every measured bin</source>
        <translation>Quadratisches Mittel von ln(Anpassung/Messung) über jede gemessene Zelle</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>Median relative difference over every measured bin</source>
        <translation>Median des relativen Unterschieds über jede gemessene Zelle</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Equation 2 of Günther et al. 2005 over the samples of the solver</source>
        <translation>Gleichung 2 von Günther et al. 2005 über die Stichprobe des Lösers</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Stichprobe</translation>
    </message>
    <message>
        <source>That the solver looked at; the errors are over every measured bin</source>
        <translation>Die der Löser ansah; die Fehler gehen über jede gemessene Zelle</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>{seconds:.1f} s</source>
        <translation>{seconds:.1f} s</translation>
    </message>
    <message>
        <source>That the fit took</source>
        <translation>Die die Anpassung brauchte</translation>
    </message>
    <message>
        <source>No session is open.</source>
        <translation>Keine Sitzung ist geöffnet.</translation>
    </message>
    <message>
        <source>Open a folder of photographs first.</source>
        <translation>Öffnen Sie zuerst einen Ordner mit Fotos.</translation>
    </message>
</context>
<context>
    <name>_000</name>
    <message>
        <source>Radius of the painted sphere</source>
        <translation>Radius der lackierten Kugel</translation>
    </message>
    <message>
        <source>From the centre of projection to the axis of the turntable, level</source>
        <translation>Vom Projektionszentrum zur Achse des Drehtellers, waagerecht</translation>
    </message>
    <message>
        <source>From the lamp to the axis of the turntable, level</source>
        <translation>Von der Lampe zur Achse des Drehtellers, waagerecht</translation>
    </message>
</context>
<context>
    <name>_000._000</name>
    <message>
        <source>Above the centre of the sphere</source>
        <translation>Über dem Mittelpunkt der Kugel</translation>
    </message>
</context>
</TS>
