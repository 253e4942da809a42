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
        <source>For all programs, from their next start on</source>
        <translation>Für alle Programme, ab ihrem nächsten Start</translation>
    </message>
    <message>
        <source>Outside sRGB: this screen shows the colour clipped to its gamut. The paint itself is not clipped.</source>
        <translation>Außerhalb von sRGB: Dieser Bildschirm zeigt die Farbe auf seinen Farbraum beschnitten. Der Lack selbst wird nicht beschnitten.</translation>
    </message>
    <message>
        <source>Colour difference CIEDE2000 between the target and the fitted lobes.</source>
        <translation>Farbabstand CIEDE2000 zwischen dem Ziel und den angepassten Keulen.</translation>
    </message>
    <message>
        <source>Flop (target above, fit below)</source>
        <translation>Flop (Ziel oben, Anpassung unten)</translation>
    </message>
    <message>
        <source>Flop over the aspecular angle</source>
        <translation>Flop über dem Aspekularwinkel</translation>
    </message>
    <message>
        <source>The grips change the flop about the face: L, C and h at either end the travel of lightness, chroma and hue, F the flop index. Drag one up or down, or choose one with Left and Right and move it with Up and Down (Shift: fine).</source>
        <translation>Die Griffe ändern den Flop um die Aufsicht: L, C und h an beiden Enden den Weg von Helligkeit, Buntheit und Buntton, F den Flop-Index. Einen nach oben oder unten ziehen, oder mit Pfeil links und rechts wählen und mit Pfeil auf und ab bewegen (Umschalt: fein).</translation>
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
        <source>target</source>
        <translation>Ziel</translation>
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
        <source>Drag up or down, or press Up and Down (Shift: fine): this end follows, the far end moves the opposite way, the face stays. A double click restores the value of the opened document.</source>
        <translation>Nach oben oder unten ziehen, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein): Dieses Ende folgt, das ferne bewegt sich entgegengesetzt, die Aufsicht bleibt. Ein Doppelklick stellt den Wert des geöffneten Dokuments wieder her.</translation>
    </message>
    <message>
        <source>Drag up for more flop and down for less, or press Up and Down (Shift: fine); the face stays. A double click restores the value of the opened document.</source>
        <translation>Nach oben ziehen für mehr Flop, nach unten für weniger, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein); die Aufsicht bleibt. Ein Doppelklick stellt den Wert des geöffneten Dokuments wieder her.</translation>
    </message>
    <message>
        <source>Drag up or down, or press Up and Down (Shift: fine): this end follows, the near end moves the opposite way, the face stays. A double click restores the value of the opened document.</source>
        <translation>Nach oben oder unten ziehen, oder Pfeil auf und Pfeil ab drücken (Umschalt: fein): Dieses Ende folgt, das nahe bewegt sich entgegengesetzt, die Aufsicht bleibt. Ein Doppelklick stellt den Wert des geöffneten Dokuments wieder her.</translation>
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
        <source>Flop: last possible paint</source>
        <translation>Flop: letzter möglicher Lack</translation>
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
        <source>Designer closed unexpectedly. Recover unsaved work on {count} paints (newest: {when}): {names}?</source>
        <translation>Designer wurde unerwartet beendet. Ungespeicherte Arbeit an {count} Lacken (neueste: {when}) wiederherstellen: {names}?</translation>
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
        <source>Designer closed unexpectedly. Recover your unsaved work on “{name}” of {when}?</source>
        <translation>Designer wurde unerwartet beendet. Ungespeicherte Arbeit an „{name}“ von {when} wiederherstellen?</translation>
    </message>
    <message>
        <source>No file is changed.</source>
        <translation>Keine Datei wird geändert.</translation>
    </message>
    <message>
        <source>{what} {count} more will follow.</source>
        <translation>{what} {count} weitere folgen.</translation>
    </message>
    <message>
        <source>The file on disk is not changed.</source>
        <translation>Die Datei auf der Platte wird nicht geändert.</translation>
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
        <source>No file yet</source>
        <translation>Noch keine Datei</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>{title}, not saved</source>
        <translation>{title}, nicht gespeichert</translation>
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
        <source>The table approximated by a few lobes: measured values as points, the fit as a line, its components dashed.</source>
        <translation>Die Tabelle, durch wenige Keulen angenähert: Messwerte als Punkte, die Anpassung als Linie, ihre Anteile gestrichelt.</translation>
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
        <translation>GGX-Keulen</translation>
    </message>
    <message>
        <source>GGX lobes, clearcoat</source>
        <translation>GGX-Keulen, Klarlack</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Lobe model; only Cook-Torrance can be opened or saved as a paint</source>
        <translation>Keulenmodell; nur Cook-Torrance lässt sich als Lack öffnen oder speichern</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Keulen</translation>
    </message>
    <message>
        <source>Number of lobes; the last one models the sharp peak</source>
        <translation>Zahl der Keulen; die letzte bildet die scharfe Spitze nach</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Fit the lobes to the table; takes several seconds</source>
        <translation>Die Keulen an die Tabelle anpassen; dauert einige Sekunden</translation>
    </message>
    <message>
        <source>Fit Lobes</source>
        <translation>Keulen anpassen</translation>
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
        <source>Fit errors</source>
        <translation>Fehler der Anpassung</translation>
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
        <source>Start an unsaved design from this fit in a new tab</source>
        <translation>Aus dieser Anpassung einen ungespeicherten Entwurf in einem neuen Reiter beginnen</translation>
    </message>
    <message>
        <source>Save Paint…</source>
        <translation>Lack speichern …</translation>
    </message>
    <message>
        <source>Save the lobes as a .brdfpaint file for Viewer</source>
        <translation>Die Keulen als .brdfpaint-Datei für Viewer speichern</translation>
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
        <source>No table yet. Run the reconstruction first.</source>
        <translation>Noch keine Tabelle. Zuerst die Rekonstruktion ausführen.</translation>
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
        <translation>Keule {number}</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Lack</translation>
    </message>
    <message>
        <source>Colours, gloss and flakes of the paint</source>
        <translation>Farben, Glanz und Flakes des Lacks</translation>
    </message>
    <message>
        <source>The light that the paint stands in</source>
        <translation>Das Licht, in dem der Lack steht</translation>
    </message>
    <message>
        <source>The form that carries the paint, and from where it is seen</source>
        <translation>Die Form, die den Lack trägt, und von wo sie zu sehen ist</translation>
    </message>
    <message>
        <source>The paint against a standard</source>
        <translation>Der Lack im Vergleich mit einem Standard</translation>
    </message>
    <message>
        <source>Files for other programs, and reports</source>
        <translation>Dateien für andere Programme, und Berichte</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>Das Bild</translation>
    </message>
    <message>
        <source>The paint on a form, drawn anew at every edit. Drag to look from elsewhere, turn the wheel to come nearer, drag with Alt to turn the light.</source>
        <translation>Der Lack auf einer Form, bei jeder Änderung neu gezeichnet. Ziehen dreht die Ansicht, das Rad holt sie näher, Ziehen mit Alt dreht das Licht.</translation>
    </message>
    <message>
        <source>The paint</source>
        <translation>Der Lack</translation>
    </message>
    <message>
        <source>Colours at every angle, gloss and flakes. Light and form have tabs of their own beside it, and More at the end of each has the rest.</source>
        <translation>Farben bei jedem Winkel, Glanz und Flakes. Licht und Form haben eigene Reiter daneben; alles Weitere steht jeweils am Ende unter „Mehr“.</translation>
    </message>
    <message>
        <source>Compare and export</source>
        <translation>Vergleichen und exportieren</translation>
    </message>
    <message>
        <source>Compare judges the paint against a standard. Export, beside it, writes files for instruments and other programs, and reports.</source>
        <translation>„Vergleichen“ beurteilt den Lack gegen einen Bezug. „Export“ daneben schreibt Dateien für Messgeräte und andere Programme sowie Berichte.</translation>
    </message>
    <message>
        <source>Compare the paint with a paint, a palette, CxF3 or a measured BRDF in a file</source>
        <translation>Den Lack mit einem Lack, einer Palette, CxF3 oder einer gemessenen BRDF aus einer Datei vergleichen</translation>
    </message>
    <message>
        <source>Load Standard…</source>
        <translation>Bezug laden …</translation>
    </message>
    <message>
        <source>Show or hide L*, C* and h over the aspecular angle</source>
        <translation>L*, C* und h über dem Aspekularwinkel ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Gloss and flakes</source>
        <translation>Glanz und Flakes</translation>
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
        <source>Open &amp;Sample Paint</source>
        <translation>&amp;Beispiellack öffnen</translation>
    </message>
    <message>
        <source>Panel &amp;Tabs</source>
        <translation>Reiter des &amp;Bedienfelds</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Close Tab</source>
        <translation>Reiter s&amp;chließen</translation>
    </message>
    <message>
        <source>Close Ot&amp;her Tabs</source>
        <translation>An&amp;dere Reiter schließen</translation>
    </message>
    <message>
        <source>Close A&amp;ll Tabs</source>
        <translation>A&amp;lle Reiter schließen</translation>
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
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save changes to “{name}”?</source>
        <translation>Änderungen an „{name}“ speichern?</translation>
    </message>
    <message>
        <source>Your changes will be lost if you don&apos;t save them.</source>
        <translation>Ohne Speichern gehen die Änderungen verloren.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Datei geändert</translation>
    </message>
    <message>
        <source>“{name}” was changed by another program since it was opened or saved here.</source>
        <translation>„{name}“ wurde von einem anderen Programm geändert, seit sie hier geöffnet oder gespeichert wurde.</translation>
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
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
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
        <source>Other programs: {what}</source>
        <translation>Andere Programme: {what}</translation>
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
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>Paint Strip</source>
        <translation>Lackleiste</translation>
    </message>
    <message>
        <source>Open {program}</source>
        <translation>{program} öffnen</translation>
    </message>
    <message>
        <source>Show or Hide P&amp;anels</source>
        <translation>Bedienf&amp;elder zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Start &amp;Page</source>
        <translation>Start&amp;seite</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
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
        <source>Copy &amp;Diagnostics</source>
        <translation>&amp;Diagnose kopieren</translation>
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
        <source>Versions, OpenGL, settings and the log were copied, without names and contents of files.</source>
        <translation>Versionen, OpenGL, Einstellungen und das Protokoll wurden kopiert, ohne Namen und Inhalte von Dateien.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Start it from a terminal: {command}.</source>
        <translation>Starten Sie es in einem Terminal: {command}.</translation>
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
        <source>{place}, in {folder}</source>
        <translation>{place}, in {folder}</translation>
    </message>
    <message>
        <source>Internal error: {fault}</source>
        <translation>Interner Fehler: {fault}</translation>
    </message>
    <message>
        <source>Your document is unchanged; save it. The log has the details.</source>
        <translation>Das Dokument ist unverändert; es sollte gespeichert werden. Das Protokoll nennt die Einzelheiten.</translation>
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
        <translation>E&amp;rscheinungsbild</translation>
    </message>
    <message>
        <source>L*, C* and h over the aspecular angle</source>
        <translation>L*, C* und h über dem Aspekularwinkel</translation>
    </message>
    <message>
        <source>L*, C*, h over angle</source>
        <translation>L*, C*, h über dem Winkel</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>L*, C* and h: last possible paint</source>
        <translation>L*, C* und h: letzter möglicher Lack</translation>
    </message>
    <message>
        <source>Curves of the last possible paint</source>
        <translation>Kurven des letzten möglichen Lacks</translation>
    </message>
    <message>
        <source>Earlier curves</source>
        <translation>Frühere Kurven</translation>
    </message>
    <message>
        <source>Points are the targets at the measured angles; drag one up or down to change it.</source>
        <translation>Die Punkte sind die Ziele an den gemessenen Winkeln; zum Ändern nach oben oder unten ziehen.</translation>
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
        <source>Show plot of {name}</source>
        <translation>Diagramm von {name} zeigen</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>Lack</translation>
    </message>
    <message>
        <source>Takes effect in Viewer and Designer at their next start, in Lobe Visualizer at once.</source>
        <translation>Gilt in Viewer und Designer ab deren nächstem Start, in Lobe Visualizer sofort.</translation>
    </message>
    <message>
        <source>Designer closed unexpectedly. Reopen the paints that were open: {names}?</source>
        <translation>Designer wurde unerwartet beendet. Die geöffneten Lacke wieder öffnen: {names}?</translation>
    </message>
    <message>
        <source>Reopen</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>The open paint is unchanged.</source>
        <translation>Der offene Lack ist unverändert.</translation>
    </message>
    <message>
        <source>Refractive index n of the clearcoat: a higher index reflects more. Resins have 1.45 to 1.55. Changing it changes both gloss readings.</source>
        <translation>Brechzahl n des Klarlacks: Eine höhere reflektiert mehr. Harze haben 1,45 bis 1,55. Eine Änderung ändert beide Glanzwerte.</translation>
    </message>
    <message>
        <source>Roughness α of the clearcoat: spread of the facet slopes (Beckmann). A new car has 0.003, satin 0.05. Changing it changes both gloss readings.</source>
        <translation>Rauheit α des Klarlacks: Streuung der Facettenneigungen (Beckmann). Ein neues Auto hat 0,003, seidenmatt ist 0,05. Eine Änderung ändert beide Glanzwerte.</translation>
    </message>
    <message>
        <source>Haze index: gloss at 60° minus gloss at 20° (common practice for ASTM D4039), GU. Light scattered close to the mirror direction raises it and makes a glossy coat look milky. A smooth clearcoat has about 5 to 12.</source>
        <translation>Haze-Index: Glanz bei 60° minus Glanz bei 20° (übliche Praxis zu ASTM D4039), GU. Licht, das nahe der Spiegelrichtung gestreut wird, erhöht ihn und lässt einen glänzenden Lack milchig aussehen. Ein glatter Klarlack hat etwa 5 bis 12.</translation>
    </message>
    <message>
        <source>Root mean square slope of the waves. A tenth of a degree is visible at arm&apos;s length.</source>
        <translation>Quadratisches Mittel der Wellenneigung. Ein Zehntelgrad ist auf Armlänge sichtbar.</translation>
    </message>
    <message>
        <source>Specify 60° gloss</source>
        <translation>60°-Glanz angeben</translation>
    </message>
    <message>
        <source>Both readings determine the refractive index. With 20° alone it is 1.5, or the value that the reading requires.</source>
        <translation>Beide Werte bestimmen die Brechzahl. Mit 20° allein ist sie 1,5 oder der Wert, den die Messung verlangt.</translation>
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
        <source>Waviness of a sprayed coat. Viewer renders it; a view can override it.</source>
        <translation>Welligkeit eines gespritzten Klarlacks. Viewer zeigt sie; eine Ansicht kann sie ersetzen.</translation>
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
        <source>–, impossible coat</source>
        <translation>–, unmöglicher Klarlack</translation>
    </message>
    <message>
        <source>{haze:.1f} GU, {source}</source>
        <translation>{haze:.1f} GU, {source}</translation>
    </message>
    <message>
        <source>A coat with n {ior:.3f} and α {roughness:.4f} has the same gloss at 20 and 60°. The paint stores the readings, and the coat with n closest to 1.5 is used.</source>
        <translation>Ein Klarlack mit n {ior:.3f} und α {roughness:.4f} hat denselben Glanz bei 20 und 60°. Der Lack speichert die Messwerte; verwendet wird der Klarlack, dessen n näher an 1,5 liegt.</translation>
    </message>
    <message>
        <source>Edit &amp;One Angle</source>
        <translation>&amp;Einen Winkel ändern</translation>
    </message>
    <message>
        <source>Edit &amp;All Angles</source>
        <translation>&amp;Alle Winkel ändern</translation>
    </message>
    <message>
        <source>Edit &amp;Flop</source>
        <translation>&amp;Flop ändern</translation>
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
        <source>&amp;Go to First Value</source>
        <translation>Zum ersten &amp;Wert gehen</translation>
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
        <source>Custom angles</source>
        <translation>Eigene Winkel</translation>
    </message>
    <message>
        <source>Aspecular angles at which the colour is specified. Another set is filled with the colours of this paint at the new angles, so the appearance is kept.</source>
        <translation>Aspekularwinkel, an denen die Farbe angegeben ist. Ein anderer Satz übernimmt die Farben dieses Lacks an den neuen Winkeln, sodass das Aussehen bleibt.</translation>
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
        <source>An edit changes the colour at one angle only.</source>
        <translation>Eine Änderung gilt nur der Farbe an einem Winkel.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Shipped</source>
        <translation>Mitgeliefert</translation>
    </message>
    <message>
        <source>Search by name</source>
        <translation>Nach Namen suchen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Where the entries come from</source>
        <translation>Woher die Einträge kommen</translation>
    </message>
    <message>
        <source>An edit adds the same difference at all angles.</source>
        <translation>Eine Änderung addiert dieselbe Differenz an allen Winkeln.</translation>
    </message>
    <message>
        <source>Flop</source>
        <translation>Flop</translation>
    </message>
    <message>
        <source>Flop: change of colour from the view near the mirror direction to the grazing view. An edit keeps the face (45°) and moves the angles on either side.</source>
        <translation>Flop: Änderung der Farbe vom Blick nahe der Spiegelrichtung zum streifenden Blick. Eine Änderung hält die Aufsicht (45°) und bewegt die Winkel zu beiden Seiten.</translation>
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
        <source>Add a reading at this angle with the current colour of the paint.</source>
        <translation>Einen Wert an diesem Winkel hinzufügen, mit der jetzigen Farbe des Lacks.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Colour space</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>Angles that an edit changes</source>
        <translation>Winkel, die eine Änderung betrifft</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Aspecular angle of the new reading, with the light at {light:g}°.</source>
        <translation>Aspekularwinkel des neuen Werts, mit dem Licht bei {light:g}°.</translation>
    </message>
    <message>
        <source>This paint is impossible.</source>
        <translation>Dieser Lack ist nicht möglich.</translation>
    </message>
    <message>
        <source>No combination of lobes produces the target colour at {angles}.</source>
        <translation>Keine Kombination der Keulen ergibt die Zielfarbe bei {angles}.</translation>
    </message>
    <message>
        <source>No possible paint was found close to it. Change a colour or the gloss.</source>
        <translation>In der Nähe wurde kein möglicher Lack gefunden. Ändern Sie eine Farbe oder den Glanz.</translation>
    </message>
    <message>
        <source>Closest possible paint: {paint}.</source>
        <translation>Nächster möglicher Lack: {paint}.</translation>
    </message>
    <message>
        <source>Use Closest</source>
        <translation>Nächsten verwenden</translation>
    </message>
    <message>
        <source>The search for the closest possible paint failed: {error}</source>
        <translation>Die Suche nach dem nächsten möglichen Lack schlug fehl: {error}</translation>
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
        <source>Lightness L* (CIE 1976, D65, 10°). A perfect white diffuser has 100; a metallic can exceed it near the mirror direction.</source>
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
        <source>Hue angle hab: 0° red, 90° yellow, 180° green, 270° blue. A grey has no hue; this value is used as soon as it has chroma.</source>
        <translation>Bunttonwinkel hab: 0° Rot, 90° Gelb, 180° Grün, 270° Blau. Ein Grau hat keinen Buntton; dieser Wert gilt, sobald es Buntheit hat.</translation>
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
        <source>Angle from the mirror direction of the light to the view: the aspecular angle.</source>
        <translation>Winkel von der Spiegelrichtung des Lichts zum Blick: der Aspekularwinkel.</translation>
    </message>
    <message>
        <source>Remove the reading at {angle}</source>
        <translation>Wert bei {angle} entfernen</translation>
    </message>
    <message>
        <source>The last valid value is kept.</source>
        <translation>Der letzte gültige Wert bleibt.</translation>
    </message>
    <message>
        <source>Use Roughness {roughness:.4f}</source>
        <translation>Rauheit {roughness:.4f} verwenden</translation>
    </message>
    <message>
        <source>The numbers keep your edit. Curves, strip and the other programs show the last possible paint.</source>
        <translation>Die Zahlen behalten die Eingabe. Kurven, Streifen und die anderen Programme zeigen den letzten möglichen Lack.</translation>
    </message>
    <message>
        <source>The paint could not be sent to the other programs: {reason}.</source>
        <translation>Der Lack konnte nicht an die anderen Programme gesendet werden: {reason}.</translation>
    </message>
    <message>
        <source>They keep the previous paint.</source>
        <translation>Sie behalten den vorigen Lack.</translation>
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
        <source>With this roughness the coat alone reflects {share:.4f} of the light at {angle:g}°, more than the colour there. With index {ior:.3f} the roughness can be up to {most:.4f}.</source>
        <translation>Mit dieser Rauheit reflektiert der Klarlack allein bei {angle:g}° {share:.4f} des Lichts, mehr als die Farbe dort. Mit der Brechzahl {ior:.3f} kann die Rauheit höchstens {most:.4f} betragen.</translation>
    </message>
    <message>
        <source>Change Flop Index</source>
        <translation>Flop-Index ändern</translation>
    </message>
    <message>
        <source>Change Chroma and Hue at All Angles</source>
        <translation>Buntheit und Buntton an allen Winkeln ändern</translation>
    </message>
    <message>
        <source>Change Chroma and Hue at {angle}</source>
        <translation>Buntheit und Buntton bei {angle} ändern</translation>
    </message>
    <message>
        <source>Turn Hue at All Angles</source>
        <translation>Buntton an allen Winkeln drehen</translation>
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
        <source>Change Coat Index</source>
        <translation>Brechzahl des Klarlacks ändern</translation>
    </message>
    <message>
        <source>Change Coat Roughness</source>
        <translation>Rauheit des Klarlacks ändern</translation>
    </message>
    <message>
        <source>Change Texture Targets</source>
        <translation>Ziele der Textur ändern</translation>
    </message>
    <message>
        <source>Orange Peel On</source>
        <translation>Orangenhaut ein</translation>
    </message>
    <message>
        <source>Flakes On</source>
        <translation>Flakes ein</translation>
    </message>
    <message>
        <source>Make Solid</source>
        <translation>Uni machen</translation>
    </message>
    <message>
        <source>Use Closest Paint</source>
        <translation>Nächsten Lack verwenden</translation>
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
        <source>Viewer renders these flakes individually in the brightest lights. The mean colour still matches the readings.</source>
        <translation>Viewer zeigt diese Flakes einzeln in den hellsten Lichtern. Die mittlere Farbe entspricht weiter den Messwerten.</translation>
    </message>
    <message>
        <source>Visible flakes</source>
        <translation>Sichtbare Flakes</translation>
    </message>
    <message>
        <source>Flop index</source>
        <translation>Flop-Index</translation>
    </message>
    <message>
        <source>Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high flop. It needs readings at 15, 45 and 110°.</source>
        <translation>Flop-Index 2,69 (L*15 − L*110)^1,11 / L*45^0,86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop. Er braucht Werte bei 15, 45 und 110°.</translation>
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
        <source>Travel of hue: rotation in degrees from the nearest to the farthest angle, positive from red towards yellow. A grey has no hue.</source>
        <translation>Bunttonweg: Drehung in Grad vom nächsten zum fernsten Winkel, positiv von Rot nach Gelb. Ein Grau hat keinen Buntton.</translation>
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
        <source>New paint or palette</source>
        <translation>Neuer Lack oder neue Palette</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Eine Ansicht öffnen</translation>
    </message>
    <message>
        <source>Open an environment</source>
        <translation>Eine Umgebung öffnen</translation>
    </message>
    <message>
        <source>Open a surface</source>
        <translation>Eine Oberfläche öffnen</translation>
    </message>
    <message>
        <source>Open a palette</source>
        <translation>Eine Palette öffnen</translation>
    </message>
    <message>
        <source>Add from the library</source>
        <translation>Aus der Bibliothek hinzufügen</translation>
    </message>
    <message>
        <source>New from a measurement</source>
        <translation>Neu aus einer Messung</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>Save the traced picture</source>
        <translation>Das strahlverfolgte Bild speichern</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Close tab or palette</source>
        <translation>Reiter oder Palette schließen</translation>
    </message>
    <message>
        <source>Reopen the closed tab</source>
        <translation>Den geschlossenen Reiter wieder öffnen</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Copy the curves</source>
        <translation>Die Kurven kopieren</translation>
    </message>
    <message>
        <source>Copy the figures</source>
        <translation>Die Zahlen kopieren</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>Invert the selection</source>
        <translation>Die Auswahl umkehren</translation>
    </message>
    <message>
        <source>Rename the group</source>
        <translation>Die Gruppe umbenennen</translation>
    </message>
    <message>
        <source>Edit the tags</source>
        <translation>Die Stichwörter bearbeiten</translation>
    </message>
    <message>
        <source>Edit the notes</source>
        <translation>Die Notizen bearbeiten</translation>
    </message>
    <message>
        <source>Move the swatch up</source>
        <translation>Das Muster nach oben</translation>
    </message>
    <message>
        <source>Move the swatch down</source>
        <translation>Das Farbmuster nach unten</translation>
    </message>
    <message>
        <source>Dissolve the group</source>
        <translation>Die Gruppe auflösen</translation>
    </message>
    <message>
        <source>Move the reflectance up</source>
        <translation>Die Reflexion nach oben</translation>
    </message>
    <message>
        <source>Move the reflectance down</source>
        <translation>Die Reflexion nach unten</translation>
    </message>
    <message>
        <source>Remove the reflectance</source>
        <translation>Die Reflexion entfernen</translation>
    </message>
    <message>
        <source>View or form by number</source>
        <translation>Blickrichtung oder Form nach Nummer</translation>
    </message>
    <message>
        <source>Frame all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Turntable, or sweep of the incidence</source>
        <translation>Drehteller, oder Durchlauf des Einfalls</translation>
    </message>
    <message>
        <source>Figures over the picture</source>
        <translation>Zahlen über dem Bild</translation>
    </message>
    <message>
        <source>Lamps in the picture</source>
        <translation>Lampen im Bild</translation>
    </message>
    <message>
        <source>Put the highlight where you click</source>
        <translation>Glanzlicht dorthin setzen, wo geklickt wird</translation>
    </message>
    <message>
        <source>Reset the view options</source>
        <translation>Die Optionen der Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Die Filter löschen</translation>
    </message>
    <message>
        <source>Show or hide the panels</source>
        <translation>Die Bedienfelder zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Show or hide the panels, in the picture</source>
        <translation>Die Bedienfelder zeigen oder verbergen, im Bild</translation>
    </message>
    <message>
        <source>Two panes</source>
        <translation>Zwei Bereiche</translation>
    </message>
    <message>
        <source>Go to the other pane</source>
        <translation>Zum anderen Bereich</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Paint strip</source>
        <translation>Lackleiste</translation>
    </message>
    <message>
        <source>Three lights</source>
        <translation>Drei Lichter</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Farbkarte</translation>
    </message>
    <message>
        <source>Render in real time</source>
        <translation>In Echtzeit zeichnen</translation>
    </message>
    <message>
        <source>Render by ray tracing</source>
        <translation>Mit Strahlverfolgung zeichnen</translation>
    </message>
    <message>
        <source>Render by path tracing</source>
        <translation>Mit Pfadverfolgung zeichnen</translation>
    </message>
    <message>
        <source>Stop refining</source>
        <translation>Verfeinern anhalten</translation>
    </message>
    <message>
        <source>Resume refining</source>
        <translation>Verfeinern fortsetzen</translation>
    </message>
    <message>
        <source>Alternate between A and B</source>
        <translation>Zwischen A und B wechseln</translation>
    </message>
    <message>
        <source>Switch between A and B, and stay</source>
        <translation>Auf A oder B schalten und bleiben</translation>
    </message>
    <message>
        <source>Keep A as B</source>
        <translation>A als B behalten</translation>
    </message>
    <message>
        <source>Next paint</source>
        <translation>Nächster Lack</translation>
    </message>
    <message>
        <source>Previous paint</source>
        <translation>Voriger Lack</translation>
    </message>
    <message>
        <source>Next tab or reflectance</source>
        <translation>Nächster Reiter oder nächste Reflexion</translation>
    </message>
    <message>
        <source>Previous tab or reflectance</source>
        <translation>Voriger Reiter oder vorige Reflexion</translation>
    </message>
    <message>
        <source>Pick the colour of an angle</source>
        <translation>Die Farbe eines Winkels wählen</translation>
    </message>
    <message>
        <source>Go to the first value</source>
        <translation>Zum ersten Wert</translation>
    </message>
    <message>
        <source>Edit one angle</source>
        <translation>Einen Winkel bearbeiten</translation>
    </message>
    <message>
        <source>Edit all angles</source>
        <translation>Alle Winkel bearbeiten</translation>
    </message>
    <message>
        <source>Edit the flop</source>
        <translation>Den Flop bearbeiten</translation>
    </message>
    <message>
        <source>Colours in L*a*b*</source>
        <translation>Farben in L*a*b*</translation>
    </message>
    <message>
        <source>Colours in LCh</source>
        <translation>Farben in LCh</translation>
    </message>
    <message>
        <source>Use this state as standard</source>
        <translation>Diesen Stand als Bezug nehmen</translation>
    </message>
    <message>
        <source>Load a standard</source>
        <translation>Einen Bezug laden</translation>
    </message>
    <message>
        <source>Find the nearest</source>
        <translation>Das Ähnlichste finden</translation>
    </message>
    <message>
        <source>Compare the two selected</source>
        <translation>Die beiden ausgewählten vergleichen</translation>
    </message>
    <message>
        <source>Add the paint from Designer</source>
        <translation>Den Lack aus Designer hinzufügen</translation>
    </message>
    <message>
        <source>Send to Designer</source>
        <translation>An Designer senden</translation>
    </message>
    <message>
        <source>Send to Viewer</source>
        <translation>An Viewer senden</translation>
    </message>
    <message>
        <source>Send to Lobe Visualizer</source>
        <translation>An Lobe Visualizer senden</translation>
    </message>
    <message>
        <source>Show the reflectance</source>
        <translation>Die Reflexion zeigen</translation>
    </message>
    <message>
        <source>Show the reflectance alone</source>
        <translation>Die Reflexion allein zeigen</translation>
    </message>
    <message>
        <source>Show all reflectances</source>
        <translation>Alle Reflexionen zeigen</translation>
    </message>
    <message>
        <source>Set as reference</source>
        <translation>Als Referenz nehmen</translation>
    </message>
    <message>
        <source>Open Designer</source>
        <translation>Designer öffnen</translation>
    </message>
    <message>
        <source>Open Viewer</source>
        <translation>Viewer öffnen</translation>
    </message>
    <message>
        <source>Open Lobe Visualizer</source>
        <translation>Lobe Visualizer öffnen</translation>
    </message>
    <message>
        <source>Open Color Swatch</source>
        <translation>Color Swatch öffnen</translation>
    </message>
    <message>
        <source>Tab of the panel</source>
        <translation>Reiter des Bedienfelds</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Einen Befehl finden</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Export the paint for other programs, or as a report</source>
        <translation>Den Lack für andere Programme oder als Bericht exportieren</translation>
    </message>
    <message>
        <source>Export {count} Files to a Folder</source>
        <translation>{count} Dateien in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>Open a Folder of Photographs</source>
        <translation>Ordner mit Fotos öffnen</translation>
    </message>
    <message>
        <source>Choose or Make a Folder for Photographs</source>
        <translation>Ordner für Fotos wählen oder anlegen</translation>
    </message>
    <message>
        <source>No session was opened.</source>
        <translation>Es wurde keine Sitzung geöffnet.</translation>
    </message>
    <message>
        <source>No file was written.</source>
        <translation>Keine Datei wurde geschrieben.</translation>
    </message>
    <message>
        <source>The open session is unchanged.</source>
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
        <source>session.json is unchanged.</source>
        <translation>session.json ist unverändert.</translation>
    </message>
    <message>
        <source>session.json was changed by another program since it was opened here.</source>
        <translation>session.json wurde von einem anderen Programm geändert, seit sie hier geöffnet ist.</translation>
    </message>
    <message>
        <source>Click Check Again to read it, then repeat the edit.</source>
        <translation>„Erneut prüfen“ liest sie; danach die Änderung wiederholen.</translation>
    </message>
    <message>
        <source>Simulating photographs</source>
        <translation>Fotos werden simuliert</translation>
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
        <translation>{name} wird exportiert</translation>
    </message>
    <message>
        <source>Exported: {names}.</source>
        <translation>Exportiert: {names}.</translation>
    </message>
    <message>
        <source>{name} exported.</source>
        <translation>{name} exportiert.</translation>
    </message>
    <message>
        <source>An existing file with this name is unchanged.</source>
        <translation>Eine vorhandene Datei dieses Namens ist unverändert.</translation>
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
        <source>USD Preview Surface</source>
        <translation>USD Preview Surface</translation>
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
        <source>More formats</source>
        <translation>Weitere Formate</translation>
    </message>
    <message>
        <source>Tick the formats to export.</source>
        <translation>Die Formate ankreuzen, die exportiert werden sollen.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>File format; properties of this paint that it cannot store are listed below</source>
        <translation>Dateiformat; Eigenschaften dieses Lacks, die es nicht speichern kann, stehen darunter</translation>
    </message>
    <message>
        <source>Contents of the format</source>
        <translation>Inhalt des Formats</translation>
    </message>
    <message>
        <source>Losses of the format</source>
        <translation>Verluste des Formats</translation>
    </message>
    <message>
        <source>With pictures</source>
        <translation>Mit Bildern</translation>
    </message>
    <message>
        <source>Rendered pictures of the speed form in the booth and a sphere in the sun</source>
        <translation>Gerenderte Bilder der Speedform in der Lichtkabine und einer Kugel in der Sonne</translation>
    </message>
    <message>
        <source>Compare with standard</source>
        <translation>Mit Bezug vergleichen</translation>
    </message>
    <message>
        <source>Include the differences, words and tolerances of the section Standard in the report</source>
        <translation>Abstände, Worte und Toleranzen des Abschnitts „Bezug“ in den Bericht aufnehmen</translation>
    </message>
    <message>
        <source>Export the current paint to a file of each format that is ticked</source>
        <translation>Den aktuellen Lack in eine Datei jedes angekreuzten Formats exportieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Determining losses…</source>
        <translation>Verluste werden ermittelt …</translation>
    </message>
    <message>
        <source>No losses.</source>
        <translation>Keine Verluste.</translation>
    </message>
    <message>
        <source>Losses:</source>
        <translation>Verluste:</translation>
    </message>
    <message>
        <source>Show or hide the history of this paint</source>
        <translation>Den Verlauf dieses Lacks zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Go to This State</source>
        <translation>Zu diesem Zustand &amp;gehen</translation>
    </message>
    <message>
        <source>&amp;Restore as New Step</source>
        <translation>Als neuen &amp;Schritt wiederherstellen</translation>
    </message>
    <message>
        <source>Restore Earlier State</source>
        <translation>Früheren Zustand wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Open in New Tab</source>
        <translation>In neuem Reiter ö&amp;ffnen</translation>
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
        <source>{state}, current</source>
        <translation>{state}, aktuell</translation>
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
        <source>States of this paint, oldest at the left; click one to restore it.</source>
        <translation>Zustände dieses Lacks, der älteste links; ein Klick stellt einen wieder her.</translation>
    </message>
    <message>
        <source>Interpolate</source>
        <translation>Interpolieren</translation>
    </message>
    <message>
        <source>Choose a different paint for the other end.</source>
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
        <source>Paint at the other end: an open tab, a sample paint, or a file</source>
        <translation>Lack am anderen Ende: ein offener Reiter, ein Beispiellack oder eine Datei</translation>
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
        <source>Click to use the paint at {percent:.0f} %</source>
        <translation>Klick übernimmt den Lack bei {percent:.0f} %</translation>
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
        <source>Position of the mixture: 0 % is this paint, 100 % the other one</source>
        <translation>Lage der Mischung: 0 % ist dieser Lack, 100 % der andere</translation>
    </message>
    <message>
        <source>Beyond the ends</source>
        <translation>Über die Enden hinaus</translation>
    </message>
    <message>
        <source>Extend the range from −50 to 150 %</source>
        <translation>Den Bereich auf −50 bis 150 % erweitern</translation>
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
        <source>Start a design from the readings of a virtual spectrophotometer on a measured reflectance</source>
        <translation>Einen Entwurf mit den Werten des virtuellen Spektralfotometers an einer gemessenen Reflexion beginnen</translation>
    </message>
    <message>
        <source>Measured files and paints ({patterns})</source>
        <translation>Messdateien und Lacke ({patterns})</translation>
    </message>
    <message>
        <source>The open paints are unchanged.</source>
        <translation>Die offenen Lacke sind unverändert.</translation>
    </message>
    <message>
        <source>{name} contains {count} paints. The first {opened} were opened.</source>
        <translation>{name} enthält {count} Lacke. Die ersten {opened} wurden geöffnet.</translation>
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
        <source>Angles of the design; another set measures the original again</source>
        <translation>Winkel des Entwurfs; ein anderer Satz misst das Original neu</translation>
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
        <source>ΔE00 between the design and the original at angles that were not used</source>
        <translation>ΔE00 zwischen dem Entwurf und dem Original an nicht benutzten Winkeln</translation>
    </message>
    <message>
        <source>Original as Standard</source>
        <translation>Original als Bezug</translation>
    </message>
    <message>
        <source>Compare the design with the measured original at every angle</source>
        <translation>Den Entwurf an jedem Winkel mit dem gemessenen Original vergleichen</translation>
    </message>
    <message>
        <source>Readings without a sample within {limit:g}° (nearest): {angles}</source>
        <translation>Messwerte ohne Messpunkt innerhalb von {limit:g}° (nächster): {angles}</translation>
    </message>
    <message>
        <source>† No sample of the original within {limit:g}°</source>
        <translation>† Kein Messpunkt des Originals innerhalb von {limit:g}°</translation>
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
        <source>The design cannot be compared with the original: the paint is impossible.</source>
        <translation>Der Entwurf lässt sich nicht mit dem Original vergleichen: Der Lack ist nicht möglich.</translation>
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
        <source>Gloss units at 20° (ASTM D523, ISO 2813): polished black glass of index 1.567 has 100. Coat and base together. The narrow 20° receptor distinguishes glossy coats.</source>
        <translation>Glanzeinheiten bei 20° (ASTM D523, ISO 2813): poliertes schwarzes Glas der Brechzahl 1,567 hat 100. Klarlack und Basis zusammen. Der schmale 20°-Empfänger unterscheidet glänzende Lacke.</translation>
    </message>
    <message>
        <source>Gloss units at 60°, coat and base together: the wide receptor, for coats of any gloss. Both readings determine the index and roughness of the coat.</source>
        <translation>Glanzeinheiten bei 60°, Klarlack und Basis zusammen: der weite Empfänger, für Lacke jeden Glanzes. Mit beiden Werten werden Brechzahl und Rauheit des Klarlacks bestimmt.</translation>
    </message>
    <message>
        <source>Root mean square height of the waviness of the coat, µm. A good finish has a few tenths of a micrometre.</source>
        <translation>Quadratisches Mittel der Wellenhöhe des Klarlacks, µm. Eine gute Lackierung hat einige Zehntel Mikrometer.</translation>
    </message>
    <message>
        <source>Typical distance from crest to crest, mm. Waves of 1 to 10 mm are visible at arm&apos;s length as orange peel. They blur the edges of reflections and lower the distinctness of image (DOI).</source>
        <translation>Üblicher Abstand von Kamm zu Kamm, mm. Wellen von 1 bis 10 mm sind auf Armlänge als Orangenhaut sichtbar. Sie verwischen die Kanten von Spiegelungen und mindern die Abbildungsschärfe (DOI).</translation>
    </message>
    <message>
        <source>Number of individually visible flakes per square millimetre. Most flakes of a paint lie too deep to be visible.</source>
        <translation>Zahl der einzeln sichtbaren Flakes je Quadratmillimeter. Die meisten Flakes eines Lacks liegen dafür zu tief.</translation>
    </message>
    <message>
        <source>Mean diameter of a flake, µm; larger flakes are brighter and sparkle more coarsely.</source>
        <translation>Mittlerer Durchmesser eines Flakes, µm; größere Flakes sind heller und glitzern gröber.</translation>
    </message>
    <message>
        <source>Spread of the flake tilts as the root mean square slope m: about 0.15 to 0.19 for metallic paints. A wider spread sparkles at more angles, but less at each.</source>
        <translation>Streuung der Flake-Neigungen, als quadratisches Mittel der Steigung m: etwa 0,15 bis 0,19 für Metalliclacke. Breitere Streuung glitzert an mehr Winkeln und an jedem weniger.</translation>
    </message>
    <message>
        <source>Variation of the flake colours: 0 all equal, 1 all hues.</source>
        <translation>Streuung der Flake-Farben: 0 alle gleich, 1 alle Bunttöne.</translation>
    </message>
    <message>
        <source>Scale of the base in the mirror direction, where instruments do not measure.</source>
        <translation>Skalierung der Basis in der Spiegelrichtung, in der Geräte nicht messen.</translation>
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
        <source>Interpolation between the measured angles: a bell of flake tilts, a monotone curve through L*a*b*, or a parabola.</source>
        <translation>Interpolation zwischen den gemessenen Winkeln: eine Glocke von Flake-Neigungen, eine monotone Kurve durch L*a*b* oder eine Parabel.</translation>
    </message>
    <message>
        <source>Not measured: instruments with three angles do not measure below 15°.</source>
        <translation>Nicht gemessen: Geräte mit drei Winkeln messen nicht unter 15°.</translation>
    </message>
    <message>
        <source>Opened with: {rule}</source>
        <translation>Geöffnet mit: {rule}</translation>
    </message>
    <message>
        <source>Not measured: no reading is closer to the mirror direction than {angle:g}°.</source>
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
        <source>Tilt of the optical axis, positive upwards</source>
        <translation>Neigung der optischen Achse, nach oben positiv</translation>
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
        <source>Known zero error of the turntable; added to every stated angle</source>
        <translation>Bekannter Nullfehler des Drehtellers; wird zu jedem angegebenen Winkel addiert</translation>
    </message>
    <message>
        <source>Height above the centre of the sphere</source>
        <translation>Höhe über dem Mittelpunkt der Kugel</translation>
    </message>
    <message>
        <source>Horizontal distance from the centre of projection to the axis of the turntable</source>
        <translation>Waagerechter Abstand vom Projektionszentrum zur Achse des Drehtellers</translation>
    </message>
    <message>
        <source>Horizontal distance from the lamp to the axis of the turntable</source>
        <translation>Waagerechter Abstand von der Lampe zur Achse des Drehtellers</translation>
    </message>
    <message>
        <source>Radius of the painted sphere</source>
        <translation>Radius der lackierten Kugel</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>Photographs of the painted sphere in a folder, described by a session.json.</source>
        <translation>Fotos der lackierten Kugel in einem Ordner, beschrieben durch eine session.json.</translation>
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
        <source>Open a folder with a session.json</source>
        <translation>Einen Ordner mit einer session.json öffnen</translation>
    </message>
    <message>
        <source>New Folder…</source>
        <translation>Neuer Ordner …</translation>
    </message>
    <message>
        <source>Create a folder with a session.json template for new photographs</source>
        <translation>Einen Ordner mit einer session.json zum Ausfüllen für neue Fotos anlegen</translation>
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
        <source>Check all photographs of the folder again</source>
        <translation>Alle Fotos des Ordners erneut prüfen</translation>
    </message>
    <message>
        <source>Changes are saved immediately. Undo: Ctrl+Z.</source>
        <translation>Änderungen werden sofort gespeichert. Rückgängig: Strg+Z.</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Contents of the session</source>
        <translation>Inhalt der Sitzung</translation>
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
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name in session.json</source>
        <translation>Name in session.json</translation>
    </message>
    <message>
        <source>{count}, {first:g} to {last:g}°</source>
        <translation>{count}, {first:g} bis {last:g}°</translation>
    </message>
    <message>
        <source>Lamp angles; 0° is at the camera</source>
        <translation>Lampenwinkel; 0° ist bei der Kamera</translation>
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
        <source>Exposures of each position, shortest first</source>
        <translation>Belichtungen jeder Stellung, die kürzeste zuerst</translation>
    </message>
    <message>
        <source>{bits} bits, response: {response}</source>
        <translation>{bits} Bit, Kennlinie: {response}</translation>
    </message>
    <message>
        <source>Encoding of the pixel values</source>
        <translation>Kodierung der Pixelwerte</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Errors: {count}. Fix them, or the affected photographs are skipped.</source>
        <translation>Fehler: {count}. Beheben Sie sie, sonst werden die betroffenen Fotos übersprungen.</translation>
    </message>
    <message>
        <source>No errors. Notes: {count}.</source>
        <translation>Keine Fehler. Hinweise: {count}.</translation>
    </message>
    <message>
        <source>{count} photographs checked, no problems.</source>
        <translation>{count} Fotos geprüft, keine Mängel.</translation>
    </message>
    <message>
        <source>Problems found by the check: file, kind and reason</source>
        <translation>Bei der Prüfung gefundene Mängel: Datei, Art und Grund</translation>
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
        <source>Name of the paint</source>
        <translation>Name des Lacks</translation>
    </message>
    <message>
        <source>Source of the readings</source>
        <translation>Herkunft der Messwerte</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Bits per code</source>
        <translation>Bit je Code</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>Code without light, per channel</source>
        <translation>Der Code ohne Licht, je Kanal</translation>
    </message>
    <message>
        <source>Reliable</source>
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
        <source>Standard deviation in the dark, relative to the full scale of a linear camera</source>
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
        <source>Largest difference between a stated exposure time and its estimate from the photographs</source>
        <translation>Größter Unterschied zwischen einer angegebenen Belichtungszeit und ihrer Schätzung aus den Fotos</translation>
    </message>
    <message>
        <source>Nonlinearity</source>
        <translation>Nichtlinearität</translation>
    </message>
    <message>
        <source>RMS distance of the curve from a straight line, in the logarithm of the exposure</source>
        <translation>Mittlerer quadratischer Abstand der Kurve von einer Geraden, im Logarithmus der Belichtung</translation>
    </message>
    <message>
        <source>Photographs that were used</source>
        <translation>Verwendete Fotos</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Iterations until convergence</source>
        <translation>Durchläufe bis zur Konvergenz</translation>
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
        <source>Root mean square distance of the detected edge from the fitted outline</source>
        <translation>Mittlerer quadratischer Abstand des erkannten Randes vom angepassten Umriss</translation>
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
        <source>Distance of found from expected highlights after the refinement</source>
        <translation>Abstand der gefundenen von den erwarteten Glanzlichtern nach der Verfeinerung</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Residuals before the refinement, with the values of session.json</source>
        <translation>Residuen vor der Verfeinerung, mit den Werten der session.json</translation>
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
        <source>The others are outliers, such as a second reflection or the arm</source>
        <translation>Die anderen sind Ausreißer, etwa eine zweite Spiegelung oder der Arm</translation>
    </message>
    <message>
        <source>{column:.1f}, {row:.1f} px</source>
        <translation>{column:.1f}; {row:.1f} px</translation>
    </message>
    <message>
        <source>Centre of its outline: column and row</source>
        <translation>Mitte ihres Umrisses: Spalte und Zeile</translation>
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
        <source>Distance of the corners of the board from the positions that the calibrated camera predicts</source>
        <translation>Abstand der Ecken der Kalibriertafel von den Positionen, die die kalibrierte Kamera vorhersagt</translation>
    </message>
    <message>
        <source>{value} ± {sigma}
stated {stated}</source>
        <translation>{value} ± {sigma}
angegeben {stated}</translation>
    </message>
    <message>
        <source>The highlights determine {share:.0f} % of it: {why}</source>
        <translation>Die Glanzlichter bestimmen {share:.0f} % davon: {why}</translation>
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
        <source>Share of the bins with light and view up to 75° from the normal; the others are filled from neighbours</source>
        <translation>Anteil der Zellen mit Licht und Blick bis 75° von der Normalen; die übrigen sind aus Nachbarn gefüllt</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Pixels used for the table</source>
        <translation>Für die Tabelle verwendete Pixel</translation>
    </message>
    <message>
        <source>Lamp positions</source>
        <translation>Stellungen der Lampe</translation>
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
        <source>Preparing the light: {name}</source>
        <translation>Licht wird vorbereitet: {name}</translation>
    </message>
    <message>
        <source>Loading the form: {name}</source>
        <translation>Form wird geladen: {name}</translation>
    </message>
    <message>
        <source>Preparing the ground and shadows of the form</source>
        <translation>Boden und Schatten der Form werden vorbereitet</translation>
    </message>
    <message>
        <source>The picture is unchanged.</source>
        <translation>Das Bild ist unverändert.</translation>
    </message>
    <message>
        <source>Three L&amp;ights</source>
        <translation>Drei L&amp;ichter</translation>
    </message>
    <message>
        <source>The paint in three lights at once: studio, street and sun</source>
        <translation>Der Lack in drei Lichtern zugleich: Studio, Straße und Sonne</translation>
    </message>
    <message>
        <source>Three Lights</source>
        <translation>Drei Lichter</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Camera and shadows</source>
        <translation>Kamera und Schatten</translation>
    </message>
    <message>
        <source>The paint on the form</source>
        <translation>Der Lack auf der Form</translation>
    </message>
    <message>
        <source>Light booth</source>
        <translation>Lichtkabine</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>Photo studio</source>
        <translation>Fotostudio</translation>
    </message>
    <message>
        <source>Street</source>
        <translation>Straße</translation>
    </message>
    <message>
        <source>Speed form</source>
        <translation>Speedform</translation>
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
        <source>Hue angle hab over the aspecular angle, unwrapped. A grey has no hue and no point.</source>
        <translation>Bunttonwinkel hab über dem Aspekularwinkel, abgewickelt. Ein Grau hat keinen Buntton und keinen Punkt.</translation>
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
        <source>Drag a point, or choose one with Left and Right and move it with Up and Down (Shift: fine).</source>
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
        <source>The paints were not swapped.</source>
        <translation>Die Lacke wurden nicht getauscht.</translation>
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
        <source>The stored standard is used. Load the file again to use its current contents.</source>
        <translation>Der gespeicherte Bezug wird verwendet. Die Datei neu laden, um ihren jetzigen Inhalt zu verwenden.</translation>
    </message>
    <message>
        <source>Standards ({patterns})</source>
        <translation>Bezüge ({patterns})</translation>
    </message>
    <message>
        <source>Some paints cannot be compared: {reasons}</source>
        <translation>Manche Lacke lassen sich nicht vergleichen: {reasons}</translation>
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
        <source>CMC (l:c), custom weights</source>
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
        <source>No standard. Use the current state, or load a paint, a palette, CxF3 or a measured BRDF. The edited paint is then the batch that is compared with it.</source>
        <translation>Kein Bezug. Den jetzigen Zustand verwenden, oder einen Lack, eine Palette, CxF3 oder eine gemessene BRDF laden. Der bearbeitete Lack ist dann die Probe, die mit ihm verglichen wird.</translation>
    </message>
    <message>
        <source>This State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Use the current state as the standard</source>
        <translation>Den jetzigen Zustand als Bezug verwenden</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Load an open tab, a sample paint, or a file: paint, palette, CxF3, measured BRDF</source>
        <translation>Einen offenen Reiter, einen Beispiellack oder eine Datei laden: Lack, Palette, CxF3, gemessene BRDF</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Edit the standard and compare it with the current paint</source>
        <translation>Den Bezug bearbeiten und mit dem jetzigen Lack vergleichen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the standard</source>
        <translation>Den Bezug entfernen</translation>
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
        <source>&amp;Sample Paint</source>
        <translation>&amp;Beispiellack</translation>
    </message>
    <message>
        <source>Paint of this file that is the standard</source>
        <translation>Lack dieser Datei, der der Bezug ist</translation>
    </message>
    <message>
        <source>Differences in words</source>
        <translation>Unterschiede in Worten</translation>
    </message>
    <message>
        <source>Batch minus standard at each aspecular angle, and the verdict of the tolerance</source>
        <translation>Probe minus Bezug an jedem Aspekularwinkel und das Urteil der Toleranz</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Formula of ΔE and its tolerances</source>
        <translation>Formel von ΔE und seinen Toleranzen</translation>
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
        <source>CMC(l:c) divides the lightness difference by l and the chroma difference by c</source>
        <translation>CMC(l:c) teilt den Helligkeitsabstand durch l und den Buntheitsabstand durch c</translation>
    </message>
    <message>
        <source>A larger weight permits a larger difference</source>
        <translation>Ein größeres Gewicht erlaubt einen größeren Abstand</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>Permitted difference at each aspecular angle, in units of the formula above</source>
        <translation>Zulässiger Abstand an jedem Aspekularwinkel, in Einheiten der Formel darüber</translation>
    </message>
    <message>
        <source>ΔL*, ΔC*, ΔH* as one ellipsoid</source>
        <translation>ΔL*, ΔC*, ΔH* als ein Ellipsoid</translation>
    </message>
    <message>
        <source>Evaluate the three components together, with their tolerances as half axes; otherwise separately</source>
        <translation>Die drei Anteile zusammen bewerten, mit ihren Toleranzen als Halbachsen; sonst einzeln</translation>
    </message>
    <message>
        <source>Batches</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Paints compared with this standard; Return or a double click opens one</source>
        <translation>Mit diesem Bezug verglichene Lacke; Eingabe oder Doppelklick öffnet einen</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Compare more paints with this standard</source>
        <translation>Weitere Lacke mit diesem Bezug vergleichen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove the added paints; the tabs remain</source>
        <translation>Die hinzugefügten Lacke entfernen; die Reiter bleiben</translation>
    </message>
    <message>
        <source>ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>nicht bewertet</translation>
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
        <source>No comparison: no common angle</source>
        <translation>Kein Vergleich: kein gemeinsamer Winkel</translation>
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
        <source>Outside the tolerance: {parts}</source>
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
        <source>Largest {part} that passes; empty: not evaluated</source>
        <translation>Größter Betrag von {part}, der gut ist; leer: nicht bewertet</translation>
    </message>
    <message>
        <source>“{text}” is not a tolerance. Enter a number of 0 or more, or leave it empty.</source>
        <translation>„{text}“ ist keine Toleranz. Eine Zahl ab 0 eingeben oder leer lassen.</translation>
    </message>
    <message>
        <source>Batches compared with the standard</source>
        <translation>Mit dem Bezug verglichene Proben</translation>
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
        <translation>Flop +</translation>
    </message>
    <message>
        <source>less flop</source>
        <translation>Flop −</translation>
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
        <source>† The nearest sample of the standard is {angle:.0f}° away.</source>
        <translation>† Der nächste Messpunkt des Standards ist {angle:.0f}° entfernt.</translation>
    </message>
    <message>
        <source>Flop: darkening of the paint from face to flop, as the index
2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 for a solid colour, about 15 to 17 for a very high flop.
First the target, then the value achieved by the fitted lobes.</source>
        <translation>Flop: Abdunklung des Lacks von der Aufsicht zum Flop, als Index
2,69 (L*15 − L*110)^1,11 / L*45^0,86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop.
Zuerst das Ziel, dann der mit den angepassten Keulen erreichte Wert.</translation>
    </message>
    <message>
        <source>Largest colour difference CIEDE2000 between the target and the fitted lobes, at the measured angles and between them; then the time of the fit, and whether the fit is exact or was stopped by the time limit.</source>
        <translation>Größter Farbabstand CIEDE2000 zwischen dem Ziel und den angepassten Keulen, an den gemessenen Winkeln und dazwischen; dann die Zeit der Anpassung, und ob sie genau ist oder am Zeitlimit endete.</translation>
    </message>
    <message>
        <source>Whether this screen, taken as sRGB, can show the measured colours.</source>
        <translation>Ob dieser Bildschirm, als sRGB angenommen, die gemessenen Farben zeigen kann.</translation>
    </message>
    <message>
        <source>Gamut</source>
        <translation>Farbraum</translation>
    </message>
    <message>
        <source>How colours between the measured angles are found, where that has been changed.</source>
        <translation>Wie Farben zwischen den gemessenen Winkeln gefunden werden, wenn das geändert wurde.</translation>
    </message>
    <message>
        <source>Programs that follow the edits of this paint.</source>
        <translation>Programme, die den Änderungen dieses Lacks folgen.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
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
        <source>Model changed: {rule}</source>
        <translation>Modell geändert: {rule}</translation>
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
        <source>These values are those of the last possible paint.</source>
        <translation>Dies sind die Werte des letzten möglichen Lacks.</translation>
    </message>
    <message>
        <source>Connected: {programs}</source>
        <translation>Verbunden: {programs}</translation>
    </message>
    <message>
        <source>Not connected</source>
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
        <source>Flop {target}</source>
        <translation>Flop {target}</translation>
    </message>
    <message>
        <source>{flop}, achieved {achieved}</source>
        <translation>{flop}, erreicht {achieved}</translation>
    </message>
    <message>
        <source>{angle}: target {target}, fit {fit}, ΔE00 {difference}</source>
        <translation>{angle}: Ziel {target}, Anpassung {fit}, ΔE00 {difference}</translation>
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
        <source>Deeper</source>
        <translation>Tiefer</translation>
    </message>
    <message>
        <source>Warmer</source>
        <translation>Wärmer</translation>
    </message>
    <message>
        <source>Finer Flakes</source>
        <translation>Feinere Flakes</translation>
    </message>
    <message>
        <source>Coarser Flakes</source>
        <translation>Gröbere Flakes</translation>
    </message>
    <message>
        <source>deeper</source>
        <translation>tiefer</translation>
    </message>
    <message>
        <source>warmer</source>
        <translation>wärmer</translation>
    </message>
    <message>
        <source>finer flakes</source>
        <translation>feinere Flakes</translation>
    </message>
    <message>
        <source>coarser flakes</source>
        <translation>gröbere Flakes</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>{reason} Discs show the readings instead.</source>
        <translation>{reason} Stattdessen zeigen Scheiben die Messwerte.</translation>
    </message>
    <message>
        <source>{word}: none</source>
        <translation>{word}: keine</translation>
    </message>
    <message>
        <source>Click to use it. Flakes of {size:.1f} µm, {density:.0f} per mm².</source>
        <translation>Klicken, um sie zu verwenden. Flakes von {size:.1f} µm, {density:.0f} je mm².</translation>
    </message>
    <message>
        <source>No paint of this kind matches these colours exactly: ΔE00 up to {missed:.1f}. L*a*b*:</source>
        <translation>Kein Lack dieser Art trifft diese Farben genau: ΔE00 bis {missed:.1f}. L*a*b*:</translation>
    </message>
    <message>
        <source>Click to use it. L*a*b*:</source>
        <translation>Klick übernimmt ihn. L*a*b*:</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>flop +</source>
        <translation>Flop +</translation>
    </message>
    <message>
        <source>finer</source>
        <translation>feiner</translation>
    </message>
    <message>
        <source>coarser</source>
        <translation>gröber</translation>
    </message>
    <message>
        <source>More variations</source>
        <translation>Weitere Varianten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Distance of the neighbours in ΔL*, ΔC* or ΔH*, approximately ΔE*ab</source>
        <translation>Abstand der Nachbarn in ΔL*, ΔC* oder ΔH*, ungefähr ΔE*ab</translation>
    </message>
    <message>
        <source>Read from simulated pictures of the flakes, from 500 mm, by an eye that resolves one minute of arc, on a scale of BRDF Suite: not comparable with the indices of makers of instruments.</source>
        <translation>Aus simulierten Bildern der Flakes gelesen, aus 500 mm, von einem Auge, das eine Bogenminute auflöst, auf einer Skala von BRDF Suite: nicht mit den Kennzahlen von Geräteherstellern vergleichbar.</translation>
    </message>
    <message>
        <source>Contrast that sparkles add to the picture: root mean square of all places that are at least {contrast:.0%} brighter than the mean. The light comes from {light:g}° off the normal.</source>
        <translation>Kontrast, den das Glitzern zum Bild beiträgt: quadratisches Mittel aller Stellen, die mindestens {contrast:.0%} heller als das Mittel sind. Das Licht kommt aus {light:g}° zur Normalen.</translation>
    </message>
    <message>
        <source>Standard deviation of the picture in diffuse light, over its mean.</source>
        <translation>Standardabweichung des Bildes in diffusem Licht, geteilt durch sein Mittel.</translation>
    </message>
    <message>
        <source>– leaves it open.</source>
        <translation>– lässt ihn offen.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>To target</source>
        <translation>Zum Ziel</translation>
    </message>
    <message>
        <source>Sparkle and graininess</source>
        <translation>Glitzern und Körnigkeit</translation>
    </message>
    <message>
        <source>What sparkles add to the contrast of the picture</source>
        <translation>Was das Glitzern zum Kontrast des Bildes beiträgt</translation>
    </message>
    <message>
        <source>Share of the picture that sparkles</source>
        <translation>Anteil des Bildes, der glitzert</translation>
    </message>
    <message>
        <source>Mean contrast of the sparkling points: 1 is twice as bright as the surface</source>
        <translation>Mittlerer Kontrast der glitzernden Punkte: 1 ist doppelt so hell wie die Fläche</translation>
    </message>
    <message>
        <source>Difference from the target; bold where it is beyond the tolerance</source>
        <translation>Unterschied zum Ziel; fett, wo er die Toleranz überschreitet</translation>
    </message>
    <message>
        <source>Target, diffuse</source>
        <translation>Ziel, diffus</translation>
    </message>
    <message>
        <source>Target {angle:g}°</source>
        <translation>Ziel {angle:g}°</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Of each target, to either side</source>
        <translation>Von jedem Ziel, nach beiden Seiten</translation>
    </message>
    <message>
        <source>Use Readings</source>
        <translation>Messwerte übernehmen</translation>
    </message>
    <message>
        <source>Make the readings the targets.</source>
        <translation>Macht die Messwerte zu den Zielen.</translation>
    </message>
    <message>
        <source>Look for density, size and roughness of flakes that have these readings, as one step.</source>
        <translation>Sucht Dichte, Größe und Rauheit von Flakes mit diesen Messwerten, als ein Schritt.</translation>
    </message>
    <message>
        <source>This paint has no flakes: no sparkle, no graininess.</source>
        <translation>Dieser Lack hat keine Flakes: kein Glitzern, keine Körnigkeit.</translation>
    </message>
    <message>
        <source>{points:.2f} points/mm²</source>
        <translation>{points:.2f} Punkte/mm²</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation>innerhalb der Toleranz</translation>
    </message>
    <message>
        <source>beyond tolerance</source>
        <translation>außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>Light of the thumbnails</source>
        <translation>Licht der kleinen Bilder</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape that the thumbnails show</source>
        <translation>Form, die die kleinen Bilder zeigen</translation>
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
        <source>OpenGL 3.3 is not available, so the picture cannot be shown. Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw in software.</source>
        <translation>OpenGL 3.3 ist nicht verfügbar, daher kann das Bild nicht gezeigt werden. Den Grafiktreiber aktualisieren oder LIBGL_ALWAYS_SOFTWARE=1 setzen, um in Software zu zeichnen.</translation>
    </message>
    <message>
        <source>The graphics driver was reset several times within a minute. Close other programs that use the graphics card, update its driver, or choose a smaller environment or surface.</source>
        <translation>Der Grafiktreiber wurde innerhalb einer Minute mehrmals zurückgesetzt. Andere Programme schließen, die die Grafikkarte verwenden, den Treiber aktualisieren oder eine kleinere Umgebung oder Fläche wählen.</translation>
    </message>
    <message>
        <source>The picture could not be prepared</source>
        <translation>Das Bild konnte nicht vorbereitet werden</translation>
    </message>
    <message>
        <source>The picture cannot be drawn</source>
        <translation>Das Bild kann nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>The picture could not be drawn</source>
        <translation>Das Bild konnte nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>The graphics driver reported {problem} while drawing.</source>
        <translation>Der Grafiktreiber meldete {problem} beim Zeichnen.</translation>
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
        <source>Show or hide this section</source>
        <translation>Diesen Abschnitt zeigen oder verbergen</translation>
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
        <source>Try a S&amp;imulated Acquisition</source>
        <translation>S&amp;imulierte Aufnahme ausprobieren</translation>
    </message>
    <message>
        <source>All steps with photographs of a simulated sphere; about half a minute</source>
        <translation>Alle Schritte mit Fotos einer simulierten Kugel; etwa eine halbe Minute</translation>
    </message>
    <message>
        <source>Coverage over the half-vector angles: θh from the normal, θd between light and half vector. Hatched cells are filled from neighbours.</source>
        <translation>Abdeckung über den Halbvektorwinkeln: θh von der Normalen, θd zwischen Licht und Halbvektor. Schraffierte Zellen sind aus Nachbarn gefüllt.</translation>
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
        <source>Pixels per cell</source>
        <translation>Pixel je Zelle</translation>
    </message>
    <message>
        <source>Relative standard error</source>
        <translation>Relativer Standardfehler</translation>
    </message>
    <message>
        <source>Quantity on the map</source>
        <translation>Größe auf der Karte</translation>
    </message>
    <message>
        <source>Quantity that the grey of a cell represents</source>
        <translation>Größe, die das Grau einer Zelle darstellt</translation>
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
        <source>Save as .brdftable with the coverage, or as .binary in the MERL layout</source>
        <translation>Als .brdftable mit der Abdeckung oder als .binary in der MERL-Anordnung speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>No table yet. Run the previous step first.</source>
        <translation>Noch keine Tabelle. Zuerst den vorigen Schritt ausführen.</translation>
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
        <source>Share of measured φd bins</source>
        <translation>Anteil der gemessenen φd-Zellen</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Pixels in this cell</source>
        <translation>Pixel in dieser Zelle</translation>
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
        <source>Each position was photographed with several exposures: a short one for the highlight, a long one for the flank.</source>
        <translation>Jede Stellung wurde mehrfach belichtet: Das Glanzlicht braucht eine kurze, die Flanke eine lange Zeit.</translation>
    </message>
    <message>
        <source>Selected photograph</source>
        <translation>Gewähltes Foto</translation>
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
        <source>Position of the displayed photographs</source>
        <translation>Stellung der angezeigten Fotos</translation>
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
        <source>Brightness of the displayed picture only, in stops</source>
        <translation>Helligkeit nur des angezeigten Bildes, in Blenden</translation>
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
        <source>No photograph of this position can be read. The page Session lists the reasons.</source>
        <translation>Kein Foto dieser Stellung ist lesbar. Die Seite „Sitzung“ nennt die Gründe.</translation>
    </message>
    <message>
        <source>{time:.4g} ms
{clipped}</source>
        <translation>{time:.4g} ms
{clipped}</translation>
    </message>
    <message>
        <source>The files contain no exposure times. The times in session.json are used.</source>
        <translation>Die Dateien enthalten keine Belichtungszeiten. Es gelten die Zeiten in session.json.</translation>
    </message>
    <message>
        <source>The times of {count} files differ from session.json.</source>
        <translation>Die Zeiten von {count} Dateien weichen von session.json ab.</translation>
    </message>
    <message>
        <source>The times in the files match session.json.</source>
        <translation>Die Zeiten in den Dateien stimmen mit session.json überein.</translation>
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
        <source>Red, green and blue codes in the file</source>
        <translation>Codes für Rot, Grün und Blau in der Datei</translation>
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
        <source>“{name}” is open in a new tab in Designer. It is not saved yet.</source>
        <translation>„{name}“ ist in Designer in einem neuen Reiter geöffnet und noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Mean ΔE00 to the fitted lobes at angles that were not used: {mean:.1f}.</source>
        <translation>Mittleres ΔE00 zu den angepassten Keulen an nicht verwendeten Winkeln: {mean:.1f}.</translation>
    </message>
    <message>
        <source>RMS ln {error:.3f}</source>
        <translation>quadr. Mittel ln {error:.3f}</translation>
    </message>
    <message>
        <source>The outline gives the centre of the sphere; the positions of the highlights give the error of the lamp position.</source>
        <translation>Der Umriss gibt den Mittelpunkt der Kugel, die Lage der Glanzlichter den Fehler der Lampenstellung.</translation>
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
        <source>Residuals: found and expected highlights</source>
        <translation>Residuen: gefundene und erwartete Glanzlichter</translation>
    </message>
    <message>
        <source>Lamp angle (degrees)</source>
        <translation>Lampenwinkel (Grad)</translation>
    </message>
    <message>
        <source>Residual (px)</source>
        <translation>Residuum (px)</translation>
    </message>
    <message>
        <source>Find Sphere and Lamp</source>
        <translation>Kugel und Lampe finden</translation>
    </message>
    <message>
        <source>Find the outline and the highlights of many positions, and fit the geometry to them</source>
        <translation>Den Umriss und die Glanzlichter vieler Stellungen finden und die Geometrie daran anpassen</translation>
    </message>
    <message>
        <source>Refine from highlights</source>
        <translation>Mit den Glanzlichtern verfeinern</translation>
    </message>
    <message>
        <source>Correct the angle and height of the lamp and the centre of the sphere from the highlights</source>
        <translation>Winkel und Höhe der Lampe und den Kugelmittelpunkt anhand der Glanzlichter berichtigen</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>Refined parameters</source>
        <translation>Verfeinerte Parameter</translation>
    </message>
    <message>
        <source>Refinement</source>
        <translation>Verfeinerung</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>Factor by which the drawn differences are magnified</source>
        <translation>Faktor, um den die gezeichneten Unterschiede vergrößert sind</translation>
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
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>No highlight was found.</source>
        <translation>Kein Glanzlicht gefunden.</translation>
    </message>
    <message>
        <source>fitted outline</source>
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
        <source>excluded edge</source>
        <translation>ausgeschlossener Rand</translation>
    </message>
    <message>
        <source>{share:.0f} % of the cells contain data</source>
        <translation>{share:.0f} % der Zellen enthalten Daten</translation>
    </message>
    <message>
        <source>The mask is kept in this window. The next stroke saves it again.</source>
        <translation>Die Maske bleibt in diesem Fenster erhalten. Der nächste Strich speichert sie erneut.</translation>
    </message>
    <message>
        <source>No pixels are excluded. The mask is saved in the folder as {file}.</source>
        <translation>Keine Pixel sind ausgeschlossen. Die Maske wird im Ordner als {file} gespeichert.</translation>
    </message>
    <message>
        <source>Saved in the folder as {file}.</source>
        <translation>Im Ordner als {file} gespeichert.</translation>
    </message>
    <message>
        <source>no pixels excluded</source>
        <translation>alle Pixel genutzt</translation>
    </message>
    <message>
        <source>outline of the sphere</source>
        <translation>Umriss der Kugel</translation>
    </message>
    <message>
        <source>Paint over the arm, its reflection and dust to exclude them. The lower half is always excluded.</source>
        <translation>Arm, Spiegelung des Arms und Staub übermalen, um sie auszuschließen. Die untere Hälfte ist immer ausgeschlossen.</translation>
    </message>
    <message>
        <source>Mask over a photograph</source>
        <translation>Maske über einem Foto</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Ausschließen</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>Einschließen</translation>
    </message>
    <message>
        <source>The brush excludes pixels from the measurement (X switches)</source>
        <translation>Der Pinsel schließt Pixel von der Messung aus (X wechselt)</translation>
    </message>
    <message>
        <source>The brush includes pixels in the measurement again (X switches)</source>
        <translation>Der Pinsel schließt Pixel wieder in die Messung ein (X wechselt)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the brush; [ and ] change it while the picture has the focus</source>
        <translation>Radius des Pinsels; [ und ] ändern ihn, wenn das Bild den Fokus hat</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last stroke (Ctrl+Z)</source>
        <translation>Den letzten Strich zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone stroke (Ctrl+Shift+Z)</source>
        <translation>Den letzten zurückgenommenen Strich wiederholen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Include All</source>
        <translation>Alles einschließen</translation>
    </message>
    <message>
        <source>Replace the mask by one that excludes no pixels</source>
        <translation>Die Maske durch eine ersetzen, die keine Pixel ausschließt</translation>
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
        <source>Position of the photograph below the mask</source>
        <translation>Stellung des Fotos unter der Maske</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>Ausgeschlossen</translation>
    </message>
    <message>
        <source>Share of all pixels of the picture that the mask excludes</source>
        <translation>Anteil aller Pixel des Bildes, den die Maske ausschließt</translation>
    </message>
    <message>
        <source>Lamp at {angle:g}°</source>
        <translation>Lampe bei {angle:g}°</translation>
    </message>
    <message>
        <source>Drag to paint (Ctrl: erase). Keys: arrows move the brush, Space paints, [ and ] change its size, X switches its mode. Wheel zooms, Shift drag pans, F frames.</source>
        <translation>Ziehen malt (Strg: radiert). Tasten: Pfeile bewegen den Pinsel, Leertaste malt, [ und ] ändern seine Größe, X wechselt seinen Modus. Mausrad zoomt, Ziehen mit Umschalt verschiebt, F rahmt ein.</translation>
    </message>
    <message>
        <source>Wheel, + and − zoom; middle drag, Shift drag and the arrow keys pan; F frames</source>
        <translation>Rad, + und − zoomen; Ziehen mit der Mitte oder Umschalt und die Pfeiltasten verschieben; F rahmt ein</translation>
    </message>
    <message>
        <source>Combines all photographs into one table of the reflectance. It can be stopped and resumed; finished positions are kept.</source>
        <translation>Fasst alle Fotos zu einer Tabelle der Reflexion zusammen. Anhalten und Fortsetzen ist jederzeit möglich; fertige Stellungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Coverage so far</source>
        <translation>Bisherige Abdeckung</translation>
    </message>
    <message>
        <source>Skipped positions</source>
        <translation>Übersprungene Stellungen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Paints to begin with</source>
        <translation>Lacke zum Anfangen</translation>
    </message>
    <message>
        <source>Begin with a paint</source>
        <translation>Mit einem Lack beginnen</translation>
    </message>
    <message>
        <source>New Paint</source>
        <translation>Neuer Lack</translation>
    </message>
    <message>
        <source>Begin with a grey metallic paint</source>
        <translation>Mit einem grauen Metallic-Lack beginnen</translation>
    </message>
    <message>
        <source>Open a Measurement…</source>
        <translation>Messung öffnen …</translation>
    </message>
    <message>
        <source>Start a design from a measured reflectance or spectrophotometer readings</source>
        <translation>Einen Entwurf aus gemessener Reflexion oder Messwerten eines Spektralphotometers beginnen</translation>
    </message>
    <message>
        <source>Try a Simulated Acquisition</source>
        <translation>Simulierte Aufnahme ausprobieren</translation>
    </message>
    <message>
        <source>Photographs of a simulated sphere, from which a paint is reconstructed step by step</source>
        <translation>Fotos einer simulierten Kugel, aus denen Schritt für Schritt ein Lack rekonstruiert wird</translation>
    </message>
    <message>
        <source>Open a Project…</source>
        <translation>Projekt öffnen …</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Recent work</source>
        <translation>Zuletzt bearbeitet</translation>
    </message>
    <message>
        <source>Files and projects that you open are listed here.</source>
        <translation>Geöffnete Dateien und Projekte stehen hier.</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Three steps through the window</source>
        <translation>In drei Schritten durch das Fenster</translation>
    </message>
    <message>
        <source>All documents, without a network</source>
        <translation>Alle Dokumente, ohne Netz</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Kennenlernen</translation>
    </message>
    <message>
        <source>Start again in {language}</source>
        <translation>Neu starten in: {language}</translation>
    </message>
    <message>
        <source>Show at start</source>
        <translation>Beim Start zeigen</translation>
    </message>
    <message>
        <source>Also in View ▸ Settings; Help ▸ Start Page shows it at any time</source>
        <translation>Auch unter Ansicht ▸ Einstellungen; Hilfe ▸ Startseite zeigt sie jederzeit</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Combine all photographs into a table of the reflectance</source>
        <translation>Alle Fotos zu einer Tabelle der Reflexion zusammenfassen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Start Over</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Discard the finished positions and start with the first one</source>
        <translation>Die fertigen Stellungen verwerfen und mit der ersten beginnen</translation>
    </message>
    <message>
        <source>Grazing cut-off</source>
        <translation>Streifgrenze</translation>
    </message>
    <message>
        <source>Largest angle of light or view from the normal; pixels beyond it are skipped</source>
        <translation>Größter Winkel von Licht oder Blick zur Normalen; Pixel jenseits davon werden übersprungen</translation>
    </message>
    <message>
        <source>Reconstruction</source>
        <translation>Rekonstruktion</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
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
        <source>Lamp positions included in the table</source>
        <translation>In der Tabelle enthaltene Stellungen der Lampe</translation>
    </message>
    <message>
        <source>Lamp positions that could not be used; the list gives the reasons</source>
        <translation>Lampenstellungen, die nicht verwendbar waren; die Liste nennt die Gründe</translation>
    </message>
    <message>
        <source>The map is updated after each position.</source>
        <translation>Die Karte wird nach jeder Stellung aktualisiert.</translation>
    </message>
    <message>
        <source>The response curve is estimated from photographs of the same light with different exposures.</source>
        <translation>Die Kennlinie wird aus Fotos desselben Lichts mit verschiedenen Belichtungen geschätzt.</translation>
    </message>
    <message>
        <source>Camera response</source>
        <translation>Kennlinie der Kamera</translation>
    </message>
    <message>
        <source>Exposure (half at the middle code)</source>
        <translation>Belichtung (½ beim mittleren Code)</translation>
    </message>
    <message>
        <source>Stated exposure times compared with estimates from the photographs</source>
        <translation>Angegebene Belichtungszeiten im Vergleich mit Schätzungen aus den Fotos</translation>
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
        <source>From session.json</source>
        <translation>Aus session.json</translation>
    </message>
    <message>
        <source>Linear camera</source>
        <translation>Lineare Kamera</translation>
    </message>
    <message>
        <source>Response type</source>
        <translation>Art der Kennlinie</translation>
    </message>
    <message>
        <source>From session.json: estimated from the photographs if session.json names no curve. Linear camera: no curve</source>
        <translation>Aus session.json: aus den Fotos geschätzt, wenn session.json keine Kurve nennt. Lineare Kamera: keine Kurve</translation>
    </message>
    <message>
        <source>Find Response</source>
        <translation>Kennlinie finden</translation>
    </message>
    <message>
        <source>Estimate the response curve from photographs of several positions</source>
        <translation>Die Kennlinie aus Fotos mehrerer Stellungen schätzen</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Kennlinie</translation>
    </message>
    <message>
        <source>Quality of the response curve</source>
        <translation>Güte der Kennlinie</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>The camera is linear.</source>
        <translation>Die Kamera ist linear.</translation>
    </message>
    <message>
        <source>Codes outside the thick lines are not reliable.</source>
        <translation>Codes außerhalb der dicken Linien sind nicht verlässlich.</translation>
    </message>
    <message>
        <source>estimated − stated</source>
        <translation>geschätzt − angegeben</translation>
    </message>
    <message>
        <source>The other steps are unchanged.</source>
        <translation>Die anderen Schritte sind unverändert.</translation>
    </message>
    <message>
        <source>Finished positions are kept. Click Resume to continue.</source>
        <translation>Fertige Stellungen bleiben erhalten. „Weiter“ setzt die Rekonstruktion fort.</translation>
    </message>
    <message>
        <source>The mask, the rig or an option has changed since. Starting over discards the earlier results.</source>
        <translation>Maske, Aufbau oder eine Option sind seither anders. „Neu beginnen“ verwirft die früheren Ergebnisse.</translation>
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
        <source>The earlier reconstruction in this folder cannot be resumed.</source>
        <translation>Die frühere Rekonstruktion in diesem Ordner lässt sich nicht fortsetzen.</translation>
    </message>
    <message>
        <source>Click Start Over on the page Reconstruction.</source>
        <translation>„Neu beginnen“ auf der Seite „Rekonstruktion“ startet eine neue.</translation>
    </message>
    <message>
        <source>{done} positions were finished in an earlier run.</source>
        <translation>{done} Stellungen wurden in einem früheren Lauf fertig.</translation>
    </message>
    <message>
        <source>{done} of {total} done</source>
        <translation>{done} von {total} getan</translation>
    </message>
    <message>
        <source>The photographs are linear files. No response curve is needed.</source>
        <translation>Die Fotos sind lineare Dateien. Eine Kennlinie ist nicht nötig.</translation>
    </message>
    <message>
        <source>Result of an earlier run. Run this step again to display it.</source>
        <translation>Ergebnis eines früheren Laufs. Diesen Schritt erneut ausführen, um es zu sehen.</translation>
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
        <source>Not saved yet. The intermediate results are kept in {file}.</source>
        <translation>Noch nicht gespeichert. Die Zwischenergebnisse liegen in {file}.</translation>
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
        <source>Stopped. Finished positions are kept.</source>
        <translation>Angehalten. Fertige Stellungen bleiben erhalten.</translation>
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
        <source>pending</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>check result</source>
        <translation>prüfen</translation>
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
        <source>Steps; Alt+1 to Alt+8, Ctrl+PgUp and Ctrl+PgDown move between them</source>
        <translation>Schritte; Alt+1 bis Alt+8, Strg+Bild auf und Strg+Bild ab wechseln zwischen ihnen</translation>
    </message>
    <message>
        <source>Alt+{number}</source>
        <translation>Alt+{number}</translation>
    </message>
    <message>
        <source>{number} of {count}</source>
        <translation>{number} von {count}</translation>
    </message>
    <message>
        <source>Leave the Tour</source>
        <translation>Beenden</translation>
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
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Previous step (Ctrl+PgUp)</source>
        <translation>Voriger Schritt (Strg+Bild auf)</translation>
    </message>
    <message>
        <source>Next step (Ctrl+PgDown)</source>
        <translation>Nächster Schritt (Strg+Bild ab)</translation>
    </message>
    <message>
        <source>Do All Steps</source>
        <translation>Alle Schritte ausführen</translation>
    </message>
    <message>
        <source>Run response, geometry, reconstruction and fit in order</source>
        <translation>Kennlinie, Geometrie, Rekonstruktion und Anpassung nacheinander ausführen</translation>
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
        <source>Mean of |ln(fit/measured)| over all measured bins: the energy of equation 2 divided by its number of terms</source>
        <translation>Mittel von |ln(Anpassung/Messung)| über alle gemessenen Zellen: die Energie aus Gleichung 2 geteilt durch die Zahl ihrer Glieder</translation>
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
        <source>Samples used by the solver; errors are computed over all measured bins</source>
        <translation>Vom Löser verwendete Stichprobe; die Fehler gelten für alle gemessenen Zellen</translation>
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
        <source>Duration of the fit</source>
        <translation>Dauer der Anpassung</translation>
    </message>
    <message>
        <source>No session is open.</source>
        <translation>Keine Sitzung ist geöffnet.</translation>
    </message>
    <message>
        <source>Open a folder of photographs first.</source>
        <translation>Öffnen Sie zuerst einen Ordner mit Fotos.</translation>
    </message>
    <message>
        <source>The {kind} that was open is unchanged.</source>
        <translation>Das geöffnete Dokument ({kind}) ist unverändert.</translation>
    </message>
    <message>
        <source>The document is still open with all changes. Choose another place with Save As.</source>
        <translation>Das Dokument ist mit allen Änderungen weiter offen. Mit „Speichern unter“ einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>the autosave cannot be written ({reason})</source>
        <translation>die automatische Sicherung kann nicht geschrieben werden ({reason})</translation>
    </message>
    <message>
        <source>unsaved work of an earlier run cannot be read ({reason})</source>
        <translation>ungespeicherte Arbeit eines früheren Laufs ist nicht lesbar ({reason})</translation>
    </message>
    <message>
        <source>it cannot be removed, and will be offered again ({reason})</source>
        <translation>lässt sich nicht entfernen und wird erneut angeboten ({reason})</translation>
    </message>
    <message>
        <source>{number} is below the minimum; the value was set to {end}.</source>
        <translation>{number} liegt unter dem Minimum; der Wert wurde auf {end} gesetzt.</translation>
    </message>
    <message>
        <source>{number} is above the maximum; the value was set to {end}.</source>
        <translation>{number} liegt über dem Maximum; der Wert wurde auf {end} gesetzt.</translation>
    </message>
    <message>
        <source>{low} to {high}; double click: {default}</source>
        <translation>{low} bis {high}; Doppelklick: {default}</translation>
    </message>
    <message>
        <source>sRGB, which macOS converts to the monitor&apos;s profile</source>
        <translation>sRGB, das macOS in das Profil des Monitors umrechnet</translation>
    </message>
    <message>
        <source>sRGB, which the Wayland compositor converts to the monitor&apos;s profile</source>
        <translation>sRGB, das der Wayland-Compositor in das Profil des Monitors umrechnet</translation>
    </message>
    <message>
        <source>No monitor profile found; assuming sRGB</source>
        <translation>Kein Monitorprofil gefunden; sRGB wird angenommen</translation>
    </message>
    <message>
        <source>The monitor&apos;s profile {reason}; assuming sRGB</source>
        <translation>Das Monitorprofil {reason}; sRGB wird angenommen</translation>
    </message>
    <message>
        <source>Monitor profile: {title}</source>
        <translation>Monitorprofil: {title}</translation>
    </message>
    <message>
        <source>Reflectances</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>Paints, palettes and measured files</source>
        <translation>Lacke, Paletten und Messdateien</translation>
    </message>
    <message>
        <source>Add from &amp;Library…</source>
        <translation>Aus der &amp;Bibliothek hinzufügen …</translation>
    </message>
    <message>
        <source>Sample paints, measured paints of Table 1, models, opened palettes</source>
        <translation>Beispiellacke, gemessene Lacke der Tabelle 1, Modelle, geöffnete Paletten</translation>
    </message>
    <message>
        <source>Reset &amp;View Options</source>
        <translation>Ansichts&amp;optionen zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default incidence, channel, radius, cosine and lobes</source>
        <translation>Einfall, Kanal, Radius, Kosinus und Keulen auf die Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Takes effect here at once, in Viewer and Designer at their next start.</source>
        <translation>Gilt hier sofort, in Viewer und Designer ab deren nächstem Start.</translation>
    </message>
    <message>
        <source>Add it as cosine lobes, Cook-Torrance lobes and homomorphic factors, each fitted to the same data</source>
        <translation>Sie als Kosinuskeulen, Cook-Torrance-Keulen und homomorphe Faktoren hinzufügen, jeweils an dieselben Daten angepasst</translation>
    </message>
    <message>
        <source>Add Re&amp;presentations</source>
        <translation>Dar&amp;stellungen hinzufügen</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Reset View</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search for the exponents that best fit these paints. Takes minutes.</source>
        <translation>Die Exponenten suchen, die am besten zu diesen Lacken passen. Dauert Minuten.</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Datenbasis</translation>
    </message>
    <message>
        <source>Paints that the search optimises the lobes for</source>
        <translation>Lacke, für die die Suche die Keulen optimiert</translation>
    </message>
    <message>
        <source>Folder of Paints…</source>
        <translation>Ordner mit Lacken …</translation>
    </message>
    <message>
        <source>Use another folder of paints as the database</source>
        <translation>Einen anderen Ordner mit Lacken als Datenbasis verwenden</translation>
    </message>
    <message>
        <source>Open a Search…</source>
        <translation>Suche öffnen …</translation>
    </message>
    <message>
        <source>Show a finished or running search from a file</source>
        <translation>Eine fertige oder laufende Suche aus einer Datei zeigen</translation>
    </message>
    <message>
        <source>Sample Paints</source>
        <translation>Beispiellacke</translation>
    </message>
    <message>
        <source>Return to the sample paints and their search</source>
        <translation>Zu den Beispiellacken und ihrer Suche zurückkehren</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>Absolut</translation>
    </message>
    <message>
        <source>Relative to the reflectance</source>
        <translation>Relativ zum Reflexionsgrad</translation>
    </message>
    <message>
        <source>By solid angle</source>
        <translation>Nach Raumwinkel</translation>
    </message>
    <message>
        <source>Fitted with the lobes</source>
        <translation>Mit den Keulen angepasst</translation>
    </message>
    <message>
        <source>Measured off the mirror direction</source>
        <translation>Abseits der Spiegelrichtung gemessen</translation>
    </message>
    <message>
        <source>Lobe Fit</source>
        <translation>Keulenanpassung</translation>
    </message>
    <message>
        <source>Default of the basis</source>
        <translation>Vorgabe der Basis</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Exponents of the lobes: the suite&apos;s own, or a file of brdf-suite basis</source>
        <translation>Exponenten der Keulen: die mitgelieferten oder eine Datei von brdf-suite basis</translation>
    </message>
    <message>
        <source>One of the counts that the basis was searched for</source>
        <translation>Eine der Anzahlen, für die die Basis gesucht wurde</translation>
    </message>
    <message>
        <source>Sample weights</source>
        <translation>Gewichte der Messpunkte</translation>
    </message>
    <message>
        <source>Paints with layers: how much each sample counts</source>
        <translation>Lacke mit Schichten: wie viel jeder Messpunkt zählt</translation>
    </message>
    <message>
        <source>Diffuse term</source>
        <translation>Diffuser Anteil</translation>
    </message>
    <message>
        <source>Paints with layers: where the diffuse term comes from</source>
        <translation>Lacke mit Schichten: woher der diffuse Anteil kommt</translation>
    </message>
    <message>
        <source>The suite&apos;s own</source>
        <translation>Mitgelieferte</translation>
    </message>
    <message>
        <source>Open a Basis</source>
        <translation>Basis öffnen</translation>
    </message>
    <message>
        <source>Bases (*.json)</source>
        <translation>Basen (*.json)</translation>
    </message>
    <message>
        <source>The suite&apos;s own lobes are used. Choose another basis with Edit ▸ Lobe Fit.</source>
        <translation>Die mitgelieferten Keulen werden verwendet. Wählen Sie eine andere Basis mit Bearbeiten ▸ Keulenanpassung.</translation>
    </message>
    <message>
        <source>Choose the exponents and the number of lobes, and how they are fitted</source>
        <translation>Exponenten und Anzahl der Keulen wählen, und wie sie angepasst werden</translation>
    </message>
    <message>
        <source>Lobe Fit…</source>
        <translation>Keulenanpassung …</translation>
    </message>
    <message>
        <source>Show the Basis</source>
        <translation>Basis zeigen</translation>
    </message>
    <message>
        <source>Scanning the folder for paints</source>
        <translation>Ordner wird nach Lacken durchsucht</translation>
    </message>
    <message>
        <source>there is no paint ({ending})</source>
        <translation>dort ist kein Lack ({ending})</translation>
    </message>
    <message>
        <source>Searching a basis for {count} paints</source>
        <translation>Basis für {count} Lacke wird gesucht</translation>
    </message>
    <message>
        <source>no search yet: choose Search</source>
        <translation>noch keine Suche: „Suchen“ wählen</translation>
    </message>
    <message>
        <source>{count} targets</source>
        <translation>{count} Ziele</translation>
    </message>
    <message>
        <source>{count} lobe counts so far</source>
        <translation>bisher {count} Keulenzahlen</translation>
    </message>
    <message>
        <source>default: {count} lobes</source>
        <translation>Vorgabe: {count} Keulen</translation>
    </message>
    <message>
        <source>paints changed since the search: search again</source>
        <translation>Lacke seit der Suche geändert: erneut suchen</translation>
    </message>
    <message>
        <source>{name}: colour error only, no separate coat</source>
        <translation>{name}: nur Farbfehler, kein getrennter Klarlack</translation>
    </message>
    <message>
        <source>Sample paints</source>
        <translation>Beispiellacke</translation>
    </message>
    <message>
        <source>Folder of Paints</source>
        <translation>Ordner mit Lacken</translation>
    </message>
    <message>
        <source>Open a Search</source>
        <translation>Suche öffnen</translation>
    </message>
    <message>
        <source>Searches (*.json *.part);;All files (*)</source>
        <translation>Suchen (*.json *.part);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Exponents over the number of lobes</source>
        <translation>Exponenten über der Zahl der Keulen</translation>
    </message>
    <message>
        <source>Errors over the number of lobes</source>
        <translation>Fehler über der Zahl der Keulen</translation>
    </message>
    <message>
        <source>Number of lobes</source>
        <translation>Zahl der Keulen</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Error (1: just noticeable)</source>
        <translation>Fehler (1: eben merklich)</translation>
    </message>
    <message>
        <source>worst paint</source>
        <translation>schlechtester Lack</translation>
    </message>
    <message>
        <source>exponents</source>
        <translation>Exponenten</translation>
    </message>
    <message>
        <source>worst: {name}</source>
        <translation>am schlechtesten: {name}</translation>
    </message>
    <message>
        <source>1 lobe</source>
        <translation>1 Keule</translation>
    </message>
    <message>
        <source>{count} lobes</source>
        <translation>{count} Keulen</translation>
    </message>
    <message>
        <source>(filled in)</source>
        <translation>(aufgefüllt)</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>Curves: values over an angle</source>
        <translation>Kurven: Werte über einem Winkel</translation>
    </message>
    <message>
        <source>log y</source>
        <translation>log y</translation>
    </message>
    <message>
        <source>Logarithmic value axis. Differences are signed and stay linear.</source>
        <translation>Logarithmische Werteachse. Differenzen haben ein Vorzeichen und bleiben linear.</translation>
    </message>
    <message>
        <source>log x</source>
        <translation>log x</translation>
    </message>
    <message>
        <source>Logarithmic angle axis, for peaks. For γ, only the side towards the normal is shown.</source>
        <translation>Logarithmische Winkelachse, für Spitzen. Bei γ wird nur die Seite zur Normalen gezeigt.</translation>
    </message>
    <message>
        <source>No reflectance shown. Add one, or show one in the legend.</source>
        <translation>Keine Reflexion gezeigt. Eine hinzufügen oder in der Legende einblenden.</translation>
    </message>
    <message>
        <source>{name}: RMS {rms} {unit} ({share} %), maximum {worst} {unit} at {angle}</source>
        <translation>{name}: quadr. Mittel {rms} {unit} ({share} %), Maximum {worst} {unit} bei {angle}</translation>
    </message>
    <message>
        <source>hatched: not measured</source>
        <translation>schraffiert: nicht gemessen</translation>
    </message>
    <message>
        <source>{name}: no values here</source>
        <translation>{name}: hier keine Werte</translation>
    </message>
    <message>
        <source>{name}: 0 everywhere</source>
        <translation>{name}: überall 0</translation>
    </message>
    <message>
        <source>Fit: RMS {rms}, worst {worst} {unit} at {angle}</source>
        <translation>Anpassung: quadr. Mittel {rms}, größte {worst} {unit} bei {angle}</translation>
    </message>
    <message>
        <source>Half angle θh (°)</source>
        <translation>Halbwinkel θh (°)</translation>
    </message>
    <message>
        <source>Difference angle θd (°)</source>
        <translation>Differenzwinkel θd (°)</translation>
    </message>
    <message>
        <source>Half-angle slice: θh and θd</source>
        <translation>Halbwinkelschnitt: θh und θd</translation>
    </message>
    <message>
        <source>updating…</source>
        <translation>wird aktualisiert …</translation>
    </message>
    <message>
        <source>No reflectance shown. Add one.</source>
        <translation>Keine Reflexion gezeigt. Eine hinzufügen.</translation>
    </message>
    <message>
        <source>{name}: measured (1) or filled in (0)</source>
        <translation>{name}: gemessen (1) oder aufgefüllt (0)</translation>
    </message>
    <message>
        <source>Lobe Visualizer, incidence {theta}°, azimuth {phi}°</source>
        <translation>Lobe Visualizer, Einfall {theta}°, Azimut {phi}°</translation>
    </message>
    <message>
        <source>{name}, fit</source>
        <translation>{name}, Anpassung</translation>
    </message>
    <message>
        <source>{name}, difference</source>
        <translation>{name}, Differenz</translation>
    </message>
    <message>
        <source>Polar</source>
        <translation>Polar</translation>
    </message>
    <message>
        <source>Unrolled</source>
        <translation>Abgewickelt</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>Halbwinkel</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Copy Curves</source>
        <translation>Kurven kopieren</translation>
    </message>
    <message>
        <source>Save Curves as CSV…</source>
        <translation>Kurven als CSV speichern …</translation>
    </message>
    <message>
        <source>Save Curves as CSV</source>
        <translation>Kurven als CSV speichern</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>RMS {share} %</source>
        <translation>quadr. Mittel {share} %</translation>
    </message>
    <message>
        <source>− {name}</source>
        <translation>− {name}</translation>
    </message>
    <message>
        <source>fit − target</source>
        <translation>Anpassung − Ziel</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>linear radius</source>
        <translation>linearer Radius</translation>
    </message>
    <message>
        <source>cube-root radius</source>
        <translation>Kubikwurzelradius</translation>
    </message>
    <message>
        <source>log radius</source>
        <translation>log. Radius</translation>
    </message>
    <message>
        <source>Polar plot of the plane of incidence</source>
        <translation>Polardiagramm der Einfallsebene</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>absolute differences</source>
        <translation>Beträge der Differenzen</translation>
    </message>
    <message>
        <source>θi {theta}°</source>
        <translation>θi {theta}°</translation>
    </message>
    <message>
        <source>φi {phi}°</source>
        <translation>φi {phi}°</translation>
    </message>
    <message>
        <source>gaps: not measured</source>
        <translation>Lücken: nicht gemessen</translation>
    </message>
    <message>
        <source>Gamma (sRGB)</source>
        <translation>Gamma (sRGB)</translation>
    </message>
    <message>
        <source>Logarithmic, 4 decades</source>
        <translation>Log., 4 Dekaden</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Cube root</source>
        <translation>Kubikwurzel</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Square root</source>
        <translation>Quadratwurzel</translation>
    </message>
    <message>
        <source>At the incidence</source>
        <translation>Beim Einfall</translation>
    </message>
    <message>
        <source>θd of the θh cut</source>
        <translation>θd, θh-Schnitt</translation>
    </message>
    <message>
        <source>θd of the cut over θh: that of the mirror configuration (the incidence), or a fixed value</source>
        <translation>θd des Schnitts über θh: das der Spiegelstellung (der Einfallswinkel) oder ein fester Wert</translation>
    </message>
    <message>
        <source>θh of the θd cut</source>
        <translation>θh, θd-Schnitt</translation>
    </message>
    <message>
        <source>θh of the cut over θd</source>
        <translation>θh des Schnitts über θd</translation>
    </message>
    <message>
        <source>φd</source>
        <translation>φd</translation>
    </message>
    <message>
        <source>Azimuth of the light about the half vector, for the cuts over θh and θd and the half-angle image</source>
        <translation>Azimut des Lichts um den Halbvektor, für die Schnitte über θh und θd und das Halbwinkelbild</translation>
    </message>
    <message>
        <source>φd, degrees</source>
        <translation>φd, Grad</translation>
    </message>
    <message>
        <source>Light of column {number}, degrees</source>
        <translation>Licht der Spalte {number}, Grad</translation>
    </message>
    <message>
        <source>Unrolled at</source>
        <translation>Abgewickelt bei</translation>
    </message>
    <message>
        <source>Incidences of the unrolled hemispheres (10°, 40° and 70° in the paper)</source>
        <translation>Einfallswinkel der abgewickelten Halbkugeln (10°, 40° und 70° in der Veröffentlichung)</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Mapping from values to brightness, shown by the scale bar</source>
        <translation>Abbildung der Werte auf Helligkeiten, durch den Skalenbalken gezeigt</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Stops above the automatic exposure of the selected reflectance</source>
        <translation>Blenden über der automatischen Belichtung der gewählten Reflexion</translation>
    </message>
    <message>
        <source>θh of images</source>
        <translation>θh der Bilder</translation>
    </message>
    <message>
        <source>Spacing of θh along the half-angle image</source>
        <translation>Teilung von θh entlang dem Halbwinkelbild</translation>
    </message>
    <message>
        <source>Polar radius</source>
        <translation>Polarradius</translation>
    </message>
    <message>
        <source>Mapping from values to radii of the polar plot. Automatic: logarithmic for high peaks.</source>
        <translation>Abbildung der Werte auf Radien des Polardiagramms. Automatisch: logarithmisch bei hohen Spitzen.</translation>
    </message>
    <message>
        <source>Measured samples</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Draw samples near a cut as rings, and samples of an image&apos;s incidence as dots</source>
        <translation>Messpunkte nahe einem Schnitt als Ringe und solche beim Einfall eines Bildes als Punkte zeichnen</translation>
    </message>
    <message>
        <source>Reset Slices</source>
        <translation>Schnitte zurücksetzen</translation>
    </message>
    <message>
        <source>Hemisphere of views on the unit square</source>
        <translation>Halbkugel der Blicke auf dem Einheitsquadrat</translation>
    </message>
    <message>
        <source>Aspecular angle γ (°)</source>
        <translation>Aspekularwinkel γ (°)</translation>
    </message>
    <message>
        <source>View angle θo (°)</source>
        <translation>Blickwinkel θo (°)</translation>
    </message>
    <message>
        <source>In the plane of incidence, over the angle from the mirror direction (positive towards the normal)</source>
        <translation>In der Einfallsebene, über dem Winkel von der Spiegelrichtung (positiv zur Normalen)</translation>
    </message>
    <message>
        <source>In the plane of incidence, over the view angle from the normal (positive on the side of the mirror direction)</source>
        <translation>In der Einfallsebene, über dem Blickwinkel von der Normalen (positiv auf der Seite der Spiegelrichtung)</translation>
    </message>
    <message>
        <source>Over the angle between half vector and normal, at the θd and φd set in Slices</source>
        <translation>Über dem Winkel zwischen Halbvektor und Normale, bei θd und φd aus „Schnitte“</translation>
    </message>
    <message>
        <source>Over the angle between light and half vector, at the θh and φd set in Slices</source>
        <translation>Über dem Winkel zwischen Licht und Halbvektor, bei θh und φd aus „Schnitte“</translation>
    </message>
    <message>
        <source>Channel of the maps</source>
        <translation>Kanal der Karten</translation>
    </message>
    <message>
        <source>Scale of the maps</source>
        <translation>Skala der Karten</translation>
    </message>
    <message>
        <source>Each map is scaled to its maximum. The logarithmic scale covers four decades.</source>
        <translation>Jede Karte ist auf ihr Maximum bezogen. Die logarithmische Skala umfasst vier Dekaden.</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>&amp;Factors</source>
        <translation>&amp;Faktoren</translation>
    </message>
    <message>
        <source>Show or hide the maps of a factored reflectance</source>
        <translation>Die Karten einer faktorisierten Reflexion zeigen oder verbergen</translation>
    </message>
    <message>
        <source>{name} is not factored.</source>
        <translation>{name} ist nicht faktorisiert.</translation>
    </message>
    <message>
        <source>Create a factored reflectance with brdf-suite factorize.</source>
        <translation>Eine faktorisierte Reflexion entsteht mit brdf-suite factorize.</translation>
    </message>
    <message>
        <source>{name}: α {alpha} 1/sr; texels: {texels}</source>
        <translation>{name}: α {alpha} 1/sr; Texel: {texels}</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>luminance</source>
        <translation>Leuchtdichte</translation>
    </message>
    <message>
        <source>perceptual</source>
        <translation>visuell</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logarithmisch</translation>
    </message>
    <message>
        <source>added peak</source>
        <translation>addierte Spitze</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>relative to maximum</source>
        <translation>bezogen auf das Maximum</translation>
    </message>
    <message>
        <source>Maps of the factors</source>
        <translation>Karten der Faktoren</translation>
    </message>
    <message>
        <source>{map}: θ {theta}°, φ {phi}°</source>
        <translation>{map}: θ {theta}°, φ {phi}°</translation>
    </message>
    <message>
        <source>{map}: at {x}</source>
        <translation>{map}: bei {x}</translation>
    </message>
    <message>
        <source>{map}: at {x}, {y}</source>
        <translation>{map}: bei {x}, {y}</translation>
    </message>
    <message>
        <source>Polar angle</source>
        <translation>Polarwinkel</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Polar angle of the light</source>
        <translation>Polarwinkel des Lichts</translation>
    </message>
    <message>
        <source>Polar angle θi</source>
        <translation>Polarwinkel θi</translation>
    </message>
    <message>
        <source>Angle between the normal and the light. The yellow handle in the view sets it, too.</source>
        <translation>Winkel zwischen der Normalen und dem Licht. Der gelbe Griff in der Ansicht stellt ihn ebenfalls ein.</translation>
    </message>
    <message>
        <source>Polar angle of the light, tenths of a degree</source>
        <translation>Polarwinkel des Lichts, Zehntelgrad</translation>
    </message>
    <message>
        <source>Azimuth of the light</source>
        <translation>Azimut des Lichts</translation>
    </message>
    <message>
        <source>Azimuth φi</source>
        <translation>Azimut φi</translation>
    </message>
    <message>
        <source>Azimuth of the plane of incidence. Affects only anisotropic reflectances, such as brushed metal.</source>
        <translation>Azimut der Einfallsebene. Wirkt nur bei anisotropen Reflexionen wie gebürstetem Metall.</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Angle that the sweep changes</source>
        <translation>Winkel, den der Durchlauf ändert</translation>
    </message>
    <message>
        <source>Speed of the sweep</source>
        <translation>Geschwindigkeit des Durchlaufs</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Move the light continuously (Space in the view)</source>
        <translation>Das Licht fortlaufend bewegen (Leertaste in der Ansicht)</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Durchgezogen</translation>
    </message>
    <message>
        <source>Dashes</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Dots</source>
        <translation>Gepunktet</translation>
    </message>
    <message>
        <source>Dash and dot</source>
        <translation>Strichpunkt</translation>
    </message>
    <message>
        <source>Long dashes</source>
        <translation>Lang gestrichelt</translation>
    </message>
    <message>
        <source>Relative RMS difference: {rms} away from the mirror direction, {all} over all directions</source>
        <translation>Relative Differenz (quadr. Mittel): {rms} abseits der Spiegelrichtung, {all} über alle Richtungen</translation>
    </message>
    <message>
        <source>Mean ΔE00 at 15°, 45°, 110°: {value}</source>
        <translation>Mittleres ΔE00 bei 15°, 45°, 110°: {value}</translation>
    </message>
    <message>
        <source>Fit: worst ΔE00 {value}</source>
        <translation>Anpassung: größtes ΔE00 {value}</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>So&amp;lo</source>
        <translation>&amp;Nur diese</translation>
    </message>
    <message>
        <source>Set as &amp;Reference</source>
        <translation>Als &amp;Referenz nehmen</translation>
    </message>
    <message>
        <source>Compute differences and errors against this reflectance</source>
        <translation>Differenzen und Fehler gegen diese Reflexion berechnen</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Um&amp;benennen</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>&amp;Alle zeigen</translation>
    </message>
    <message>
        <source>Remove All &amp;Others</source>
        <translation>Alle ande&amp;ren entfernen</translation>
    </message>
    <message>
        <source>Ne&amp;xt Reflectance</source>
        <translation>Nä&amp;chste Reflexion</translation>
    </message>
    <message>
        <source>Pre&amp;vious Reflectance</source>
        <translation>&amp;Vorige Reflexion</translation>
    </message>
    <message>
        <source>Al&amp;ternate with Reference</source>
        <translation>Mit der Referenz ab&amp;wechseln</translation>
    </message>
    <message>
        <source>Show the selected reflectance and the reference alternately</source>
        <translation>Die gewählte Reflexion und die Referenz abwechselnd zeigen</translation>
    </message>
    <message>
        <source>L&amp;ine</source>
        <translation>L&amp;inie</translation>
    </message>
    <message>
        <source>Other Colour…</source>
        <translation>Andere Farbe …</translation>
    </message>
    <message>
        <source>Reset All Lines</source>
        <translation>Alle Linien zurücksetzen</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>solo</source>
        <translation>nur diese</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>error {error}</source>
        <translation>Fehler {error}</translation>
    </message>
    <message>
        <source>Legend of reflectances</source>
        <translation>Legende der Reflexionen</translation>
    </message>
    <message>
        <source>Space: show or hide. S: solo. R: set as reference. C: colour. D: dash. F2: rename. Delete: remove. Alt+Up, Alt+Down: move.</source>
        <translation>Leertaste: zeigen oder verbergen. S: nur diese. R: als Referenz nehmen. C: Farbe. D: Strichart. F2: umbenennen. Entf: entfernen. Alt+Pfeil auf, Alt+Pfeil ab: verschieben.</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Erscheinungsbild</translation>
    </message>
    <message>
        <source>Grey of all windows; colours are judged beside it</source>
        <translation>Grau aller Fenster; daneben werden Farben beurteilt</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Help ▸ Start Page shows it at any time</source>
        <translation>Hilfe ▸ Startseite zeigt sie jederzeit</translation>
    </message>
    <message>
        <source>These settings are the same in all programs of the suite.</source>
        <translation>Diese Einstellungen gelten für alle Programme der Suite.</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Nur</translation>
    </message>
    <message>
        <source>Ref.</source>
        <translation>Ref.</translation>
    </message>
    <message>
        <source>Visibility, and line style in the plots</source>
        <translation>Sichtbarkeit, und Strichart in den Diagrammen</translation>
    </message>
    <message>
        <source>Solo: show only the reflectances ticked here</source>
        <translation>Nur: nur die hier angekreuzten Reflexionen zeigen</translation>
    </message>
    <message>
        <source>Reference for differences and errors</source>
        <translation>Referenz für Differenzen und Fehler</translation>
    </message>
    <message>
        <source>RMS difference relative to the reference, away from the mirror direction</source>
        <translation>Differenz zur Referenz (relativ, quadr. Mittel), abseits der Spiegelrichtung</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Open a file</source>
        <translation>Datei öffnen</translation>
    </message>
    <message>
        <source>Add from the library of reflectances</source>
        <translation>Aus der Bibliothek der Reflexionen hinzufügen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>No reflectances. Drop files here, or</source>
        <translation>Keine Reflexionen. Dateien hierher ziehen, oder</translation>
    </message>
    <message>
        <source>Open a File…</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Add from Library…</source>
        <translation>Aus der Bibliothek hinzufügen …</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Albedo</source>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>three angles, ASTM E2194</source>
        <translation>drei Winkel, ASTM E2194</translation>
    </message>
    <message>
        <source>five angles</source>
        <translation>fünf Winkel</translation>
    </message>
    <message>
        <source>six angles</source>
        <translation>sechs Winkel</translation>
    </message>
    <message>
        <source>two illumination angles, ASTM E2539</source>
        <translation>zwei Lichtwinkel, ASTM E2539</translation>
    </message>
    <message>
        <source>Colour geometries</source>
        <translation>Farbgeometrien</translation>
    </message>
    <message>
        <source>Open the panel Numbers (F5) and wait until they are computed.</source>
        <translation>Öffnen Sie das Bedienfeld Zahlen (F5) und warten Sie, bis sie berechnet sind.</translation>
    </message>
    <message>
        <source>Geometries of the L*a*b* values (D65, 10° observer)</source>
        <translation>Geometrien der L*a*b*-Werte (D65, 10°-Beobachter)</translation>
    </message>
    <message>
        <source>Show {name}</source>
        <translation>{name} zeigen</translation>
    </message>
    <message>
        <source>Copy the table</source>
        <translation>Die Tabelle kopieren</translation>
    </message>
    <message>
        <source>Export all figures as CSV</source>
        <translation>Alle Zahlen als CSV exportieren</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Zahlen</translation>
    </message>
    <message>
        <source>Show or hide the figures</source>
        <translation>Die Zahlen zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Copy Figures</source>
        <translation>Zahlen &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the visible table</source>
        <translation>Die sichtbare Tabelle kopieren</translation>
    </message>
    <message>
        <source>largest albedo of a channel</source>
        <translation>größte Albedo eines Kanals</translation>
    </message>
    <message>
        <source>its incidence</source>
        <translation>deren Einfallswinkel</translation>
    </message>
    <message>
        <source>directions without a number</source>
        <translation>Richtungen ohne Zahl</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>quadratisches Mittel</translation>
    </message>
    <message>
        <source>relative root mean square</source>
        <translation>relatives quadratisches Mittel</translation>
    </message>
    <message>
        <source>root mean square of cube roots</source>
        <translation>quadratisches Mittel der Kubikwurzeln</translation>
    </message>
    <message>
        <source>&amp;Export Figures…</source>
        <translation>Zahlen &amp;exportieren …</translation>
    </message>
    <message>
        <source>There are no figures to export yet.</source>
        <translation>Noch gibt es keine Zahlen zu exportieren.</translation>
    </message>
    <message>
        <source>Figures of {count} reflectances exported to {path}.</source>
        <translation>Zahlen von {count} Reflexionen nach {path} exportiert.</translation>
    </message>
    <message>
        <source>No reflectance shown.</source>
        <translation>Keine Reflexion gezeigt.</translation>
    </message>
    <message>
        <source>{fresh} of {count} computed</source>
        <translation>{fresh} von {count} berechnet</translation>
    </message>
    <message>
        <source>Set a reference in the legend (R) to see differences.</source>
        <translation>Eine Referenz in der Legende (R) setzen, um Differenzen zu sehen.</translation>
    </message>
    <message>
        <source>Albedo over the incidence</source>
        <translation>Albedo über dem Einfallswinkel</translation>
    </message>
    <message>
        <source>No albedo yet.</source>
        <translation>Noch keine Albedo.</translation>
    </message>
    <message>
        <source>Incidence θi (°)</source>
        <translation>Einfallswinkel θi (°)</translation>
    </message>
    <message>
        <source>Luminous albedo</source>
        <translation>Licht-Albedo</translation>
    </message>
    <message>
        <source>Total reflection</source>
        <translation>Totale Reflexion</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>{title}: outdated, being recomputed</source>
        <translation>{title}: veraltet, wird neu berechnet</translation>
    </message>
    <message>
        <source>Figures of the reflectances</source>
        <translation>Zahlen der Reflexionen</translation>
    </message>
    <message>
        <source>Computing statistics for {name}</source>
        <translation>Statistik für {name} wird berechnet</translation>
    </message>
    <message>
        <source>Its figures are not shown.</source>
        <translation>Ihre Zahlen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Show plot {name}</source>
        <translation>Diagramm {name} zeigen</translation>
    </message>
    <message>
        <source>Designer</source>
        <translation>Designer</translation>
    </message>
    <message>
        <source>Selected reflectance</source>
        <translation>Gewählte Reflexion</translation>
    </message>
    <message>
        <source>subject</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>Fitted lobes and fitting time</source>
        <translation>Angepasste Keulen und Zeit der Anpassung</translation>
    </message>
    <message>
        <source>Notes on the reflectance</source>
        <translation>Hinweise zur Reflexion</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Direction of the light</source>
        <translation>Richtung des Lichts</translation>
    </message>
    <message>
        <source>incidence</source>
        <translation>Einfall</translation>
    </message>
    <message>
        <source>Connected programs of the suite</source>
        <translation>Verbundene Programme der Suite</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>no fit yet</source>
        <translation>noch keine Anpassung</translation>
    </message>
    <message>
        <source>fit {ms} ms</source>
        <translation>Anpassung {ms} ms</translation>
    </message>
    <message>
        <source>worst ΔE00 {value}</source>
        <translation>größtes ΔE00 {value}</translation>
    </message>
    <message>
        <source>exact fit follows</source>
        <translation>genaue Anpassung folgt</translation>
    </message>
    <message>
        <source>best result so far</source>
        <translation>bisher bestes Ergebnis</translation>
    </message>
    <message>
        <source>time limit: {what}</source>
        <translation>Zeitlimit: {what}</translation>
    </message>
    <message>
        <source>light {theta}°, {phi}°</source>
        <translation>Licht {theta}°, {phi}°</translation>
    </message>
    <message>
        <source>Fitting lobes to {name}</source>
        <translation>Keulen werden an {name} angepasst</translation>
    </message>
    <message>
        <source>The reflectance is shown without a fit.</source>
        <translation>Die Reflexion wird ohne Anpassung gezeigt.</translation>
    </message>
    <message>
        <source>&amp;Follow Designer</source>
        <translation>&amp;Designer folgen</translation>
    </message>
    <message>
        <source>Show the paint being edited in Designer and follow every change</source>
        <translation>Den in Designer bearbeiteten Lack zeigen und jeder Änderung folgen</translation>
    </message>
    <message>
        <source>Designer: {name}</source>
        <translation>Designer: {name}</translation>
    </message>
    <message>
        <source>The previous paint is still shown.</source>
        <translation>Der vorige Lack wird weiter gezeigt.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Fit over target</source>
        <translation>Anpassung über Ziel</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Three parts</source>
        <translation>Drei Teile</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>Gestapelt</translation>
    </message>
    <message>
        <source>Separate lobes</source>
        <translation>Einzelne Keulen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What all views show of each reflectance. Differences are against the legend&apos;s reference, or else between fit and target.</source>
        <translation>Was alle Ansichten von jeder Reflexion zeigen. Differenzen gelten gegen die Referenz der Legende, sonst zwischen Anpassung und Ziel.</translation>
    </message>
    <message>
        <source>Fit style</source>
        <translation>Stil der Anpassung</translation>
    </message>
    <message>
        <source>Style of the fit where it overlays its target</source>
        <translation>Stil der Anpassung, wo sie über ihrem Ziel liegt</translation>
    </message>
    <message>
        <source>How the lobes of a fit are shown</source>
        <translation>Wie die Keulen einer Anpassung gezeigt werden</translation>
    </message>
    <message>
        <source>The selected reflectance has no fit.</source>
        <translation>Die gewählte Reflexion hat keine Anpassung.</translation>
    </message>
    <message>
        <source>Reset Parts</source>
        <translation>Teile zurücksetzen</translation>
    </message>
    <message>
        <source>Switch all lobes on and restore the default display</source>
        <translation>Alle Keulen einschalten und die Vorgabe der Anzeige wiederherstellen</translation>
    </message>
    <message>
        <source>Show the gloss of targets and fits; without it the base alone, where a paint has layers</source>
        <translation>Glanz von Zielen und Anpassungen zeigen; ohne ihn die Schicht darunter allein, wo ein Lack Schichten hat</translation>
    </message>
    <message>
        <source>Switch all lobes of this part on or off</source>
        <translation>Alle Keulen dieses Teils ein- oder ausschalten</translation>
    </message>
    <message>
        <source>KD</source>
        <translation>KD</translation>
    </message>
    <message>
        <source>E = {exponent}</source>
        <translation>E = {exponent}</translation>
    </message>
    <message>
        <source>Weight (linear Rec. 2020 red, green, blue)</source>
        <translation>Gewicht (lineares Rec. 2020, Rot, Grün, Blau)</translation>
    </message>
    <message>
        <source>{name}: cosine lobes</source>
        <translation>{name}: Kosinuskeulen</translation>
    </message>
    <message>
        <source>{name}: Cook-Torrance lobes</source>
        <translation>{name}: Cook-Torrance-Keulen</translation>
    </message>
    <message>
        <source>{name}: homomorphic factors</source>
        <translation>{name}: homomorphe Faktoren</translation>
    </message>
    <message>
        <source>is a palette without a paint</source>
        <translation>ist eine Palette ohne Lack</translation>
    </message>
    <message>
        <source>{share:.0f} % of the directions have no value (drawn as holes).</source>
        <translation>{share:.0f} % der Richtungen haben keinen Wert (als Lücken gezeichnet).</translation>
    </message>
    <message>
        <source>The reflectance is zero in every sampled direction.</source>
        <translation>Die Reflexion ist in jeder abgetasteten Richtung null.</translation>
    </message>
    <message>
        <source>All light is reflected into one narrow lobe; other views are dark.</source>
        <translation>Alles Licht wird in eine schmale Keule reflektiert; andere Blicke sind dunkel.</translation>
    </message>
    <message>
        <source>Reading {name}</source>
        <translation>{name} wird gelesen</translation>
    </message>
    <message>
        <source>The previous picture stays.</source>
        <translation>Das vorige Bild bleibt.</translation>
    </message>
    <message>
        <source>Fitting the representations of {name}</source>
        <translation>Darstellungen werden an {name} angepasst</translation>
    </message>
    <message>
        <source>The others are listed in the panel Reflectances (Ctrl+Shift+B).</source>
        <translation>Die anderen stehen im Bedienfeld Reflexionen (Strg+Umschalt+B).</translation>
    </message>
    <message>
        <source>{count} entries of {title} cannot be shown.</source>
        <translation>{count} Einträge von {title} lassen sich nicht zeigen.</translation>
    </message>
    <message>
        <source>{title} has {count} paints; the first {shown} are shown.</source>
        <translation>{title} hat {count} Lacke; die ersten {shown} werden gezeigt.</translation>
    </message>
    <message>
        <source>{title} imported with notes.</source>
        <translation>{title} mit Hinweisen importiert.</translation>
    </message>
    <message>
        <source>Measured paints of Table 1</source>
        <translation>Gemessene Lacke der Tabelle 1</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Search paints and models by name</source>
        <translation>Lacke und Modelle nach Namen suchen</translation>
    </message>
    <message>
        <source>Available reflectances</source>
        <translation>Verfügbare Reflexionen</translation>
    </message>
    <message>
        <source>Add the selected reflectances to the legend (Enter or double click)</source>
        <translation>Die gewählten Reflexionen zur Legende hinzufügen (Eingabe oder Doppelklick)</translation>
    </message>
    <message>
        <source>No reflectance matches.</source>
        <translation>Keine passende Reflexion.</translation>
    </message>
    <message>
        <source>Three-quarter view</source>
        <translation>Schrägansicht</translation>
    </message>
    <message>
        <source>Side view of the plane of incidence</source>
        <translation>Seitenansicht der Einfallsebene</translation>
    </message>
    <message>
        <source>From the light</source>
        <translation>Vom Licht aus</translation>
    </message>
    <message>
        <source>From the mirror direction</source>
        <translation>Aus der Spiegelrichtung</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Three-quarter view from behind</source>
        <translation>Schrägansicht von hinten</translation>
    </message>
    <message>
        <source>Side view from behind</source>
        <translation>Seitenansicht von hinten</translation>
    </message>
    <message>
        <source>Low, along the plane of incidence</source>
        <translation>Flach, entlang der Einfallsebene</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>{title} and {count} more</source>
        <translation>{title} und {count} weitere</translation>
    </message>
    <message>
        <source>All lobes are switched off.</source>
        <translation>Alle Keulen sind ausgeschaltet.</translation>
    </message>
    <message>
        <source>Diffuse, directional diffuse and gloss, separately</source>
        <translation>Diffus, gerichtet diffus und Glanz, einzeln</translation>
    </message>
    <message>
        <source>{count} lobes stacked, widest innermost</source>
        <translation>{count} Keulen gestapelt, die breiteste innen</translation>
    </message>
    <message>
        <source>Fit: {count} lobes</source>
        <translation>Anpassung: {count} Keulen</translation>
    </message>
    <message>
        <source>minus {title}</source>
        <translation>minus {title}</translation>
    </message>
    <message>
        <source>fit minus target</source>
        <translation>Anpassung minus Ziel</translation>
    </message>
    <message>
        <source>Only the reference is shown. Show another reflectance to see its difference.</source>
        <translation>Nur die Referenz wird gezeigt. Eine andere Reflexion einblenden, um deren Differenz zu sehen.</translation>
    </message>
    <message>
        <source>The reflectance is zero in every direction.</source>
        <translation>Die Reflexion ist in jeder Richtung null.</translation>
    </message>
    <message>
        <source>maximum {value} {unit}</source>
        <translation>Maximum {value} {unit}</translation>
    </message>
    <message>
        <source>{text}, cut off in the picture</source>
        <translation>{text}, im Bild abgeschnitten</translation>
    </message>
    <message>
        <source>Target with its fit overlaid</source>
        <translation>Ziel mit überlagerter Anpassung</translation>
    </message>
    <message>
        <source>Computing the values…</source>
        <translation>Werte werden berechnet …</translation>
    </message>
    <message>
        <source>{title} has no fit.</source>
        <translation>{title} hat keine Anpassung.</translation>
    </message>
    <message>
        <source>Outdated: computing the new values…</source>
        <translation>Veraltet: Die neuen Werte werden berechnet …</translation>
    </message>
    <message>
        <source>No values in {share} of the directions (holes).</source>
        <translation>Keine Werte in {share} der Richtungen (Lücken).</translation>
    </message>
    <message>
        <source>No values in any direction.</source>
        <translation>Keine Werte in irgendeiner Richtung.</translation>
    </message>
    <message>
        <source>Incidence</source>
        <translation>Einfall</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>OpenGL is not available, so the lobes cannot be drawn.</source>
        <translation>OpenGL ist nicht verfügbar, daher können die Keulen nicht gezeichnet werden.</translation>
    </message>
    <message>
        <source>Frame the Hemisphere</source>
        <translation>Halbkugel einrahmen</translation>
    </message>
    <message>
        <source>Sweep the Incidence</source>
        <translation>Einfall durchlaufen</translation>
    </message>
    <message>
        <source>θo {theta}°  φo {phi}°  γ {gamma}°  {value} {unit}</source>
        <translation>θo {theta}°  φo {phi}°  γ {gamma}°  {value} {unit}</translation>
    </message>
    <message>
        <source>No samples within {reach}° of this incidence; the nearest is at {angle}°.</source>
        <translation>Keine Messpunkte innerhalb von {reach}° um diesen Einfall; der nächste liegt bei {angle}°.</translation>
    </message>
    <message>
        <source>Save Picture as PNG</source>
        <translation>Bild als PNG speichern</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Save Picture as SVG</source>
        <translation>Bild als SVG speichern</translation>
    </message>
    <message>
        <source>SVG picture (*.svg)</source>
        <translation>SVG-Bild (*.svg)</translation>
    </message>
    <message>
        <source>Save Surface as OBJ</source>
        <translation>Fläche als OBJ speichern</translation>
    </message>
    <message>
        <source>Wavefront OBJ (*.obj)</source>
        <translation>Wavefront OBJ (*.obj)</translation>
    </message>
    <message>
        <source>Save Surface as PLY</source>
        <translation>Fläche als PLY speichern</translation>
    </message>
    <message>
        <source>PLY with colours (*.ply)</source>
        <translation>PLY mit Farben (*.ply)</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Höhe des Bildes</translation>
    </message>
    <message>
        <source>Length of radius 1</source>
        <translation>Länge des Radius 1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Size of PNG and SVG pictures. PNG uses 16 samples per pixel.</source>
        <translation>Größe der PNG- und SVG-Bilder. PNG verwendet 16 Abtastwerte je Pixel.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Length of radius 1 in OBJ and PLY. The file states the value it stands for.</source>
        <translation>Länge des Radius 1 in OBJ und PLY. Die Datei nennt den Wert, für den sie steht.</translation>
    </message>
    <message>
        <source>Reset Sizes</source>
        <translation>Größen zurücksetzen</translation>
    </message>
    <message>
        <source>Open Pro&amp;ject…</source>
        <translation>Pro&amp;jekt öffnen …</translation>
    </message>
    <message>
        <source>Paints, standard, views and lights of one design</source>
        <translation>Lacke, Bezug, Ansichten und Lichter eines Entwurfs</translation>
    </message>
    <message>
        <source>Save Projec&amp;t…</source>
        <translation>Projek&amp;t speichern …</translation>
    </message>
    <message>
        <source>What is open here, and all other parts of the open project</source>
        <translation>Was hier offen ist, und alle anderen Teile des offenen Projekts</translation>
    </message>
    <message>
        <source>Collect &amp;Files…</source>
        <translation>&amp;Dateien sammeln …</translation>
    </message>
    <message>
        <source>Save the project with a copy of every file that it names</source>
        <translation>Das Projekt mit einer Kopie jeder genannten Datei speichern</translation>
    </message>
    <message>
        <source>What was open is unchanged.</source>
        <translation>Was offen war, ist unverändert.</translation>
    </message>
    <message>
        <source>Saving {name}</source>
        <translation>{name} wird gespeichert</translation>
    </message>
    <message>
        <source>The project on disk is as it was. Choose another place, or correct this.</source>
        <translation>Das gespeicherte Projekt ist unverändert. Wählen Sie einen anderen Ort oder beheben Sie die Ursache.</translation>
    </message>
    <message>
        <source>Saved: {path}</source>
        <translation>Gespeichert: {path}</translation>
    </message>
    <message>
        <source>Saved: {path} ({count} files collected)</source>
        <translation>Gespeichert: {path} ({count} Dateien gesammelt)</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>Projekte</translation>
    </message>
    <message>
        <source>No surface to save. Add a reflectance, or show one in the legend.</source>
        <translation>Keine Fläche zu speichern. Eine Reflexion hinzufügen oder in der Legende einblenden.</translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation>Logarithmus</translation>
    </message>
    <message>
        <source>f_r</source>
        <translation>f_r</translation>
    </message>
    <message>
        <source>f_r·cosθi</source>
        <translation>f_r·cosθi</translation>
    </message>
    <message>
        <source>f_r·cosθi·cosθo</source>
        <translation>f_r·cosθi·cosθo</translation>
    </message>
    <message>
        <source>Luminance, grey</source>
        <translation>Leuchtdichte, grau</translation>
    </message>
    <message>
        <source>Reflected light</source>
        <translation>Reflektiertes Licht</translation>
    </message>
    <message>
        <source>Legend colour</source>
        <translation>Legendenfarbe</translation>
    </message>
    <message>
        <source>False colour</source>
        <translation>Falschfarbe</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Maximum off R</source>
        <translation>Maximum abseits R</translation>
    </message>
    <message>
        <source>Fixed value</source>
        <translation>Fester Wert</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagert</translation>
    </message>
    <message>
        <source>Hemisphere</source>
        <translation>Halbkugel</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Mapping from values to distances from the centre</source>
        <translation>Abbildung der Werte auf Abstände vom Mittelpunkt</translation>
    </message>
    <message>
        <source>Decades</source>
        <translation>Dekaden</translation>
    </message>
    <message>
        <source>Range of the logarithmic radius below its maximum</source>
        <translation>Umfang des logarithmischen Radius unter seinem Maximum</translation>
    </message>
    <message>
        <source>Value of radius 1</source>
        <translation>Wert des Radius 1</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Stays fixed while the light moves</source>
        <translation>Bleibt fest, während sich das Licht bewegt</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Quantity in all views: f_r, reflected radiance f_r·cosθi, or intensity f_r·cosθi·cosθo</source>
        <translation>Größe in allen Ansichten: f_r, reflektierte Strahldichte f_r·cosθi oder Strahlstärke f_r·cosθi·cosθo</translation>
    </message>
    <message>
        <source>Value at the hemisphere; larger values are cut off. Automatic: the maximum, or less if all but 2 % of the directions would be shorter than half a radius. Away from R: more than 5° from the mirror direction.</source>
        <translation>Wert an der Halbkugel; größere Werte werden abgeschnitten. Automatisch: das Maximum, oder weniger, wenn alle bis auf 2 % der Richtungen kürzer als ein halber Radius wären. Abseits von R: mehr als 5° von der Spiegelrichtung entfernt.</translation>
    </message>
    <message>
        <source>Channel that the radius shows (linear Rec. 2020)</source>
        <translation>Kanal, den der Radius zeigt (lineares Rec. 2020)</translation>
    </message>
    <message>
        <source>Reflected light is shown in its colour at full brightness</source>
        <translation>Reflektiertes Licht wird in seiner Farbe bei voller Helligkeit gezeigt</translation>
    </message>
    <message>
        <source>Multiple</source>
        <translation>Mehrere</translation>
    </message>
    <message>
        <source>Arrangement of several reflectances</source>
        <translation>Anordnung mehrerer Reflexionen</translation>
    </message>
    <message>
        <source>Separate scale for each panel</source>
        <translation>Eigener Maßstab für jedes Feld</translation>
    </message>
    <message>
        <source>Maximum distance of samples</source>
        <translation>Größter Abstand der Messpunkte</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>Maximum angle between a sample&apos;s incidence and the current incidence</source>
        <translation>Größter Winkel zwischen dem Einfall eines Messpunkts und dem jetzigen Einfall</translation>
    </message>
    <message>
        <source>Reset Radius</source>
        <translation>Radius zurücksetzen</translation>
    </message>
    <message>
        <source>3-D lobe plot</source>
        <translation>3-D-Keulendiagramm</translation>
    </message>
    <message>
        <source>The lobes cannot be drawn: {reason}</source>
        <translation>Die Keulen können nicht gezeichnet werden: {reason}</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Directional diffuse</source>
        <translation>Gerichtet diffus</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>{part}, E = {exponent}</source>
        <translation>{part}, E = {exponent}</translation>
    </message>
    <message>
        <source>{red} · {green} · {blue} 1/sr</source>
        <translation>{red} · {green} · {blue} 1/sr</translation>
    </message>
    <message>
        <source>&amp;Reflectance</source>
        <translation>&amp;Reflexion</translation>
    </message>
    <message>
        <source>No 3-D view</source>
        <translation>Keine 3-D-Ansicht</translation>
    </message>
    <message>
        <source>palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Color Swatch closed unexpectedly. Recover your unsaved work on “{name}” of {when}?</source>
        <translation>Color Swatch wurde unerwartet beendet. Ungespeicherte Arbeit an „{name}“ von {when} wiederherstellen?</translation>
    </message>
    <message>
        <source>Color Swatch closed unexpectedly. Recover unsaved work on {count} palettes (newest: {when}): {names}?</source>
        <translation>Color Swatch wurde unerwartet beendet. Ungespeicherte Arbeit an {count} Paletten (neueste: {when}) wiederherstellen: {names}?</translation>
    </message>
    <message>
        <source>{palette}, tag {tag}</source>
        <translation>{palette}, Stichwort {tag}</translation>
    </message>
    <message>
        <source>{palette}, nearest to {paint}</source>
        <translation>{palette}, am nächsten zu {paint}</translation>
    </message>
    <message>
        <source>1 swatch</source>
        <translation>1 Muster</translation>
    </message>
    <message>
        <source>{count} swatches</source>
        <translation>{count} Muster</translation>
    </message>
    <message>
        <source>{shown} of {count}</source>
        <translation>{shown} von {count}</translation>
    </message>
    <message>
        <source>({count}, working)</source>
        <translation>({count}, in Arbeit)</translation>
    </message>
    <message>
        <source>{palette} (read-only)</source>
        <translation>{palette} (schreibgeschützt)</translation>
    </message>
    <message>
        <source>New Palette</source>
        <translation>Neue Palette</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Choose a palette in the library, open one, or create a new one.
Files can be dropped here.</source>
        <translation>Eine Palette in der Bibliothek wählen, eine öffnen oder eine neue anlegen.
Dateien lassen sich hierher ziehen.</translation>
    </message>
    <message>
        <source>Reading {name}…</source>
        <translation>{name} wird gelesen …</translation>
    </message>
    <message>
        <source>{problem}
Repair the file or restore it from a backup, then reload it.</source>
        <translation>{problem}
Die Datei reparieren oder aus einer Sicherungskopie wiederherstellen, dann neu laden.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Remove from Library</source>
        <translation>Aus der Bibliothek entfernen</translation>
    </message>
    <message>
        <source>This palette is not loaded.</source>
        <translation>Diese Palette ist nicht geladen.</translation>
    </message>
    <message>
        <source>Open Palette</source>
        <translation>Palette öffnen</translation>
    </message>
    <message>
        <source>This palette is empty. Drop paints here, paste colours, or add the paint from Designer.</source>
        <translation>Diese Palette ist leer. Lacke hierher ziehen, Farben einfügen oder den Lack aus Designer hinzufügen.</translation>
    </message>
    <message>
        <source>Add Paints…</source>
        <translation>Lacke hinzufügen …</translation>
    </message>
    <message>
        <source>Add Paint from Designer</source>
        <translation>Lack aus Designer hinzufügen</translation>
    </message>
    <message>
        <source>No swatch matches the search and filters.</source>
        <translation>Kein Muster passt zu Suche und Filtern.</translation>
    </message>
    <message>
        <source>Clear Filters</source>
        <translation>Filter aufheben</translation>
    </message>
    <message>
        <source>This group is empty. Drop swatches here.</source>
        <translation>Diese Gruppe ist leer. Muster hierher ziehen.</translation>
    </message>
    <message>
        <source>{count} shown</source>
        <translation>{count} gezeigt</translation>
    </message>
    <message>
        <source>{count} shown, {selected} selected</source>
        <translation>{count} gezeigt, {selected} gewählt</translation>
    </message>
    <message>
        <source>Flop {flop}</source>
        <translation>Flop {flop}</translation>
    </message>
    <message>
        <source>Gloss 20°: {gloss} GU</source>
        <translation>Glanz 20°: {gloss} GU</translation>
    </message>
    <message>
        <source>60°: {gloss} GU</source>
        <translation>60°: {gloss} GU</translation>
    </message>
    <message>
        <source>Flakes: {density} /mm², {size} µm</source>
        <translation>Flakes: {density} /mm², {size} µm</translation>
    </message>
    <message>
        <source>Spot colour</source>
        <translation>Sonderfarbe</translation>
    </message>
    <message>
        <source>Global colour</source>
        <translation>Globale Farbe</translation>
    </message>
    <message>
        <source>Date {date}</source>
        <translation>Datum {date}</translation>
    </message>
    <message>
        <source>Export Palette</source>
        <translation>Palette exportieren</translation>
    </message>
    <message>
        <source>All palette formats ({endings})</source>
        <translation>Alle Palettenformate ({endings})</translation>
    </message>
    <message>
        <source>Palettes ({endings})</source>
        <translation>Paletten ({endings})</translation>
    </message>
    <message>
        <source>&amp;Export Palette…</source>
        <translation>Palette &amp;exportieren …</translation>
    </message>
    <message>
        <source>Export the palette for another program: ASE, ACO, GPL, KPL, CxF, CSV and others</source>
        <translation>Die Palette für ein anderes Programm exportieren: ASE, ACO, GPL, KPL, CxF, CSV und andere</translation>
    </message>
    <message>
        <source>Export Se&amp;lection…</source>
        <translation>Aus&amp;wahl exportieren …</translation>
    </message>
    <message>
        <source>Nothing was written. Choose another name or format.</source>
        <translation>Nichts wurde geschrieben. Einen anderen Namen oder ein anderes Format wählen.</translation>
    </message>
    <message>
        <source>Three Swatches per Paint</source>
        <translation>Drei Muster je Lack</translation>
    </message>
    <message>
        <source>“{name}” cannot store everything in the palette:</source>
        <translation>„{name}“ kann nicht alles aus der Palette speichern:</translation>
    </message>
    <message>
        <source>Paints written as three colours each, without gloss and flakes: {count}.</source>
        <translation>Lacke, die als je drei Farben ohne Glanz und Flakes geschrieben werden: {count}.</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Another Format…</source>
        <translation>Anderes Format …</translation>
    </message>
    <message>
        <source>Saved: {name}</source>
        <translation>Gespeichert: {name}</translation>
    </message>
    <message>
        <source>{format} files cannot be exported. Choose another format.</source>
        <translation>{format}-Dateien lassen sich nicht exportieren. Ein anderes Format wählen.</translation>
    </message>
    <message>
        <source>Contact S&amp;heet…</source>
        <translation>&amp;Kontaktbogen …</translation>
    </message>
    <message>
        <source>Save or print the visible or selected swatches with their figures</source>
        <translation>Sichtbare oder ausgewählte Muster mit ihren Kennzahlen speichern oder drucken</translation>
    </message>
    <message>
        <source>Folder of the Contact Sheet</source>
        <translation>Ordner des Kontaktbogens</translation>
    </message>
    <message>
        <source>Print Contact Sheet</source>
        <translation>Kontaktbogen drucken</translation>
    </message>
    <message>
        <source>The printer did not respond. Check it and print again.</source>
        <translation>Der Drucker hat nicht geantwortet. Den Drucker prüfen und erneut drucken.</translation>
    </message>
    <message>
        <source>Printed: {count} pages</source>
        <translation>Gedruckt: {count} Seiten</translation>
    </message>
    <message>
        <source>Rendering contact sheet: {name}</source>
        <translation>Kontaktbogen wird gerendert: {name}</translation>
    </message>
    <message>
        <source>Rendering contact sheet</source>
        <translation>Kontaktbogen wird gerendert</translation>
    </message>
    <message>
        <source>The palette is unchanged.</source>
        <translation>Die Palette ist unverändert.</translation>
    </message>
    <message>
        <source>ΔE00</source>
        <translation>ΔE00</translation>
    </message>
    <message>
        <source>ΔL*</source>
        <translation>ΔL*</translation>
    </message>
    <message>
        <source>Δa*</source>
        <translation>Δa*</translation>
    </message>
    <message>
        <source>Δb*</source>
        <translation>Δb*</translation>
    </message>
    <message>
        <source>ΔC*</source>
        <translation>ΔC*</translation>
    </message>
    <message>
        <source>Δh</source>
        <translation>Δh</translation>
    </message>
    <message>
        <source>Aspecular angle</source>
        <translation>Aspekularwinkel</translation>
    </message>
    <message>
        <source>Colour difference CIEDE2000</source>
        <translation>Farbabstand CIEDE2000</translation>
    </message>
    <message>
        <source>Lightness difference, second minus first</source>
        <translation>Helligkeitsdifferenz, zweites minus erstes</translation>
    </message>
    <message>
        <source>Red–green difference, second minus first</source>
        <translation>Rot-Grün-Differenz, zweites minus erstes</translation>
    </message>
    <message>
        <source>Yellow–blue difference, second minus first</source>
        <translation>Gelb-Blau-Differenz, zweites minus erstes</translation>
    </message>
    <message>
        <source>Chroma difference, second minus first</source>
        <translation>Buntheitsdifferenz, zweites minus erstes</translation>
    </message>
    <message>
        <source>Hue angle difference in degrees, second minus first</source>
        <translation>Differenz der Bunttonwinkel in Grad, zweites minus erstes</translation>
    </message>
    <message>
        <source>Both paints at each angle</source>
        <translation>Beide Lacke an jedem Winkel</translation>
    </message>
    <message>
        <source>Differences at each angle</source>
        <translation>Abstände an jedem Winkel</translation>
    </message>
    <message>
        <source>Select two swatches to compare, or one in each of two panes.</source>
        <translation>Zum Vergleichen zwei Muster wählen, oder eines in jedem von zwei Bereichen.</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(kein Name)</translation>
    </message>
    <message>
        <source>Above: {first}
Below: {second}</source>
        <translation>Oben: {first}
Unten: {second}</translation>
    </message>
    <message>
        <source>Mean ΔE00 {mean}, worst {worst}</source>
        <translation>Mittleres ΔE00 {mean}, größtes {worst}</translation>
    </message>
    <message>
        <source>Flop {first} and {second}</source>
        <translation>Flop {first} und {second}</translation>
    </message>
    <message>
        <source>Gloss 20°: {first} and {second} GU</source>
        <translation>Glanz 20°: {first} und {second} GU</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>&amp;Compare the Two Selected</source>
        <translation>Die zwei gewählten &amp;vergleichen</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>Appl&amp;y Current Sort</source>
        <translation>Jetzige &amp;Sortierung anwenden</translation>
    </message>
    <message>
        <source>Make the current sort the palette order</source>
        <translation>Die jetzige Sortierung zur Reihenfolge der Palette machen</translation>
    </message>
    <message>
        <source>Apply current sort</source>
        <translation>Jetzige Sortierung anwenden</translation>
    </message>
    <message>
        <source>Move {what}</source>
        <translation>{what} verschieben</translation>
    </message>
    <message>
        <source>Tag {what}</source>
        <translation>{what}: Stichwort vergeben</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Ohne Titel</translation>
    </message>
    <message>
        <source>Copy {what}</source>
        <translation>{what} kopieren</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>A&amp;usschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>E&amp;infügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>Du&amp;plizieren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>New Palette from Se&amp;lection…</source>
        <translation>Neue Palette aus der Auswah&amp;l …</translation>
    </message>
    <message>
        <source>Copy the selected swatches to a new palette, in a file of its own</source>
        <translation>Die ausgewählten Muster in eine neue Palette mit eigener Datei kopieren</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Alle wählen</translation>
    </message>
    <message>
        <source>Select N&amp;one</source>
        <translation>K&amp;eine wählen</translation>
    </message>
    <message>
        <source>&amp;Invert Selection</source>
        <translation>Auswahl u&amp;mkehren</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>S&amp;tichwörter</translation>
    </message>
    <message>
        <source>Not&amp;es</source>
        <translation>N&amp;otizen</translation>
    </message>
    <message>
        <source>Cut {what}</source>
        <translation>{what} ausschneiden</translation>
    </message>
    <message>
        <source>The clipboard contains no swatch, paint or colour.</source>
        <translation>Die Zwischenablage enthält kein Muster, keinen Lack und keine Farbe.</translation>
    </message>
    <message>
        <source>Copy swatches, a paint, or text with colours such as #3366cc or L*a*b* values.</source>
        <translation>Muster, einen Lack oder Text mit Farben wie #3366cc oder L*a*b*-Werten kopieren.</translation>
    </message>
    <message>
        <source>Paste {what}</source>
        <translation>{what} einfügen</translation>
    </message>
    <message>
        <source>Duplicate {what}</source>
        <translation>{what} duplizieren</translation>
    </message>
    <message>
        <source>New palette</source>
        <translation>Neue Palette</translation>
    </message>
    <message>
        <source>Delete {what}</source>
        <translation>{what} löschen</translation>
    </message>
    <message>
        <source>Rename to “{name}”</source>
        <translation>In „{name}“ umbenennen</translation>
    </message>
    <message>
        <source>Change code</source>
        <translation>Code ändern</translation>
    </message>
    <message>
        <source>Rename {what}</source>
        <translation>{what} umbenennen</translation>
    </message>
    <message>
        <source>Change notes</source>
        <translation>Notizen ändern</translation>
    </message>
    <message>
        <source>Change tags of {what}</source>
        <translation>Stichwörter von {what} ändern</translation>
    </message>
    <message>
        <source>one swatch</source>
        <translation>ein Muster</translation>
    </message>
    <message>
        <source>New G&amp;roup</source>
        <translation>Neue &amp;Gruppe</translation>
    </message>
    <message>
        <source>New group from selection</source>
        <translation>Neue Gruppe aus der Auswahl</translation>
    </message>
    <message>
        <source>Rena&amp;me Group</source>
        <translation>Gruppe umbe&amp;nennen</translation>
    </message>
    <message>
        <source>Dissol&amp;ve Group</source>
        <translation>Gruppe auf&amp;lösen</translation>
    </message>
    <message>
        <source>Remo&amp;ve Group and Swatches</source>
        <translation>Gruppe und Muster ent&amp;fernen</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>Farbe ändern</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Neue Gruppe</translation>
    </message>
    <message>
        <source>New group {number}</source>
        <translation>Neue Gruppe {number}</translation>
    </message>
    <message>
        <source>Dissolve group</source>
        <translation>Gruppe auflösen</translation>
    </message>
    <message>
        <source>Remove group</source>
        <translation>Gruppe entfernen</translation>
    </message>
    <message>
        <source>Move group</source>
        <translation>Gruppe verschieben</translation>
    </message>
    <message>
        <source>Move group “{name}”</source>
        <translation>Gruppe „{name}“ verschieben</translation>
    </message>
    <message>
        <source>Copy group “{name}”</source>
        <translation>Gruppe „{name}“ kopieren</translation>
    </message>
    <message>
        <source>Send to &amp;Designer</source>
        <translation>An &amp;Designer senden</translation>
    </message>
    <message>
        <source>Send to &amp;Viewer</source>
        <translation>An &amp;Viewer senden</translation>
    </message>
    <message>
        <source>Send to &amp;Lobe Visualizer</source>
        <translation>An &amp;Lobe Visualizer senden</translation>
    </message>
    <message>
        <source>&amp;Add Paint from Designer</source>
        <translation>Lack aus Designer &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add the paint being edited in Designer to this palette</source>
        <translation>Den in Designer bearbeiteten Lack zu dieser Palette hinzufügen</translation>
    </message>
    <message>
        <source>Find Nearest to &amp;Designer&apos;s Paint</source>
        <translation>Nächste zum Lack in &amp;Designer suchen</translation>
    </message>
    <message>
        <source>“{paint}” consists of Cook-Torrance lobes; the live link sends designed paints only.</source>
        <translation>„{paint}“ besteht aus Cook-Torrance-Keulen; die Verbindung sendet nur entworfene Lacke.</translation>
    </message>
    <message>
        <source>Open its file in {program}.</source>
        <translation>Seine Datei in {program} öffnen.</translation>
    </message>
    <message>
        <source>{program} could not be started.</source>
        <translation>{program} konnte nicht gestartet werden.</translation>
    </message>
    <message>
        <source>Start it manually; the paint is then sent to it.</source>
        <translation>Das Programm von Hand starten; der Lack wird dann gesendet.</translation>
    </message>
    <message>
        <source>Starting {program} with “{paint}”.</source>
        <translation>{program} wird mit „{paint}“ gestartet.</translation>
    </message>
    <message>
        <source>Add “{paint}”</source>
        <translation>„{paint}“ hinzufügen</translation>
    </message>
    <message>
        <source>No paint is being edited.</source>
        <translation>Kein Lack wird bearbeitet.</translation>
    </message>
    <message>
        <source>Open a paint in Designer, then try again.</source>
        <translation>Einen Lack in Designer öffnen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>{link} · in Designer: {paint}</source>
        <translation>{link} · in Designer: {paint}</translation>
    </message>
    <message>
        <source>Find &amp;Nearest</source>
        <translation>&amp;Nächste suchen</translation>
    </message>
    <message>
        <source>Sort by mean ΔE00 over 15°, 45° and 110° to the selected swatch</source>
        <translation>Nach mittlerem ΔE00 über 15°, 45° und 110° zum gewählten Muster sortieren</translation>
    </message>
    <message>
        <source>Find Nearest in &amp;Other Pane</source>
        <translation>Nächste im &amp;anderen Bereich suchen</translation>
    </message>
    <message>
        <source>Sort the other pane by mean ΔE00 to the swatch selected here</source>
        <translation>Den anderen Bereich nach mittlerem ΔE00 zum hier gewählten Muster sortieren</translation>
    </message>
    <message>
        <source>Find Nearest to Clip&amp;board</source>
        <translation>Nächste zur &amp;Zwischenablage suchen</translation>
    </message>
    <message>
        <source>Sort by mean ΔE00 to the paint, colour or L*a*b* values on the clipboard</source>
        <translation>Nach mittlerem ΔE00 zum Lack, zur Farbe oder zu den L*a*b*-Werten der Zwischenablage sortieren</translation>
    </message>
    <message>
        <source>The order is unchanged.</source>
        <translation>Die Reihenfolge ist unverändert.</translation>
    </message>
    <message>
        <source>The text on the clipboard has {count} characters; at most {most} are read. Save it as a file.</source>
        <translation>Der Text in der Zwischenablage hat {count} Zeichen; höchstens {most} werden gelesen. Speichern Sie ihn als Datei.</translation>
    </message>
    <message>
        <source>The swatches on the clipboard are damaged.</source>
        <translation>Die Muster der Zwischenablage sind beschädigt.</translation>
    </message>
    <message>
        <source>The text on the clipboard is not a valid paint ({reason}).</source>
        <translation>Der Text der Zwischenablage ist kein gültiger Lack ({reason}).</translation>
    </message>
    <message>
        <source>Show as &amp;Spheres</source>
        <translation>Als &amp;Kugeln zeigen</translation>
    </message>
    <message>
        <source>Show as Curved &amp;Panels</source>
        <translation>Als gewölbte &amp;Bleche zeigen</translation>
    </message>
    <message>
        <source>Show as &amp;Flop Strips</source>
        <translation>Als &amp;Flop-Streifen zeigen</translation>
    </message>
    <message>
        <source>Show as Flat &amp;Chips</source>
        <translation>Als flache &amp;Plättchen zeigen</translation>
    </message>
    <message>
        <source>Show as &amp;List</source>
        <translation>Als &amp;Liste zeigen</translation>
    </message>
    <message>
        <source>&amp;Larger Swatches</source>
        <translation>&amp;Größere Muster</translation>
    </message>
    <message>
        <source>S&amp;maller Swatches</source>
        <translation>&amp;Kleinere Muster</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>S&amp;uchen</translation>
    </message>
    <message>
        <source>Clear Filte&amp;rs</source>
        <translation>Filt&amp;er aufheben</translation>
    </message>
    <message>
        <source>&amp;Two Panes</source>
        <translation>&amp;Zwei Bereiche</translation>
    </message>
    <message>
        <source>Go to the &amp;Other Pane</source>
        <translation>In den &amp;anderen Bereich</translation>
    </message>
    <message>
        <source>Ungrouped</source>
        <translation>Ohne Gruppe</translation>
    </message>
    <message>
        <source>{count} similar</source>
        <translation>{count} ähnliche</translation>
    </message>
    <message>
        <source>{count} similar, differences up to ΔE00 {widest}</source>
        <translation>{count} ähnliche, Abstände bis ΔE00 {widest}</translation>
    </message>
    <message>
        <source>{title}, by steps</source>
        <translation>{title}, in Stufen</translation>
    </message>
    <message>
        <source>Gloss 20° (GU)</source>
        <translation>Glanz 20° (GU)</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Stichwörter</translation>
    </message>
    <message>
        <source>Name of the paint (rename: F2)</source>
        <translation>Name des Lacks (umbenennen: F2)</translation>
    </message>
    <message>
        <source>Manufacturer&apos;s code or your own</source>
        <translation>Code des Herstellers oder ein eigener</translation>
    </message>
    <message>
        <source>Gloss at 20° in gloss units (GU), coat and base together</source>
        <translation>Glanz bei 20° in Glanzeinheiten (GU), Klarlack und Basis zusammen</translation>
    </message>
    <message>
        <source>Flop index 2.69 (L*15 − L*110)^1.11 / L*45^0.86; 0 for a solid colour</source>
        <translation>Flop-Index 2,69 (L*15 − L*110)^1,11 / L*45^0,86; 0 für eine Unifarbe</translation>
    </message>
    <message>
        <source>Search terms</source>
        <translation>Suchbegriffe</translation>
    </message>
    <message>
        <source>Date of the last change (year-month-day)</source>
        <translation>Datum der letzten Änderung (Jahr-Monat-Tag)</translation>
    </message>
    <message>
        <source>CIE {axis}* (D65, 10°) at the aspecular angle {angle}°</source>
        <translation>CIE {axis}* (D65, 10°) am Aspekularwinkel {angle}°</translation>
    </message>
    <message>
        <source>Colour chips</source>
        <translation>Farbfelder</translation>
    </message>
    <message>
        <source>Colours at 15°, 45° and 110°</source>
        <translation>Farben bei 15°, 45° und 110°</translation>
    </message>
    <message>
        <source>Flop index and gloss</source>
        <translation>Flop-Index und Glanz</translation>
    </message>
    <message>
        <source>L*a*b* at 15°, 45° and 110°</source>
        <translation>L*a*b* bei 15°, 45° und 110°</translation>
    </message>
    <message>
        <source>Contact Sheet</source>
        <translation>Kontaktbogen</translation>
    </message>
    <message>
        <source>Preview of the page</source>
        <translation>Vorschau der Seite</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Hochformat</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Querformat</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Name of the file: .pdf, or .png for a picture</source>
        <translation>Name der Datei: .pdf, oder .png für ein Bild</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Anderen Ordner wählen</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Vorherige Seite</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>All {count} shown</source>
        <translation>Alle {count} angezeigten</translation>
    </message>
    <message>
        <source>{count} selected</source>
        <translation>{count} ausgewählte</translation>
    </message>
    <message>
        <source>L*a*b*: D65, 10°, light at 45°</source>
        <translation>L*a*b*: D65, 10°, Licht bei 45°</translation>
    </message>
    <message>
        <source>{form}, {light}; L*a*b*: D65, 10°, light at 45°</source>
        <translation>{form}, {light}; L*a*b*: D65, 10°, Licht bei 45°</translation>
    </message>
    <message>
        <source>Page {page} of {count}</source>
        <translation>Seite {page} von {count}</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Der Datei einen Namen geben.</translation>
    </message>
    <message>
        <source>{name} is there already and will be replaced.</source>
        <translation>{name} gibt es schon und wird ersetzt.</translation>
    </message>
    <message>
        <source>Preparing pictures: {count} to go</source>
        <translation>Bilder werden vorbereitet: noch {count}</translation>
    </message>
    <message>
        <source>Swatches, second pane</source>
        <translation>Muster, zweiter Bereich</translation>
    </message>
    <message>
        <source>Grid of swatches</source>
        <translation>Raster der Muster</translation>
    </message>
    <message>
        <source>Active pane</source>
        <translation>Aktiver Bereich</translation>
    </message>
    <message>
        <source>Close pane</source>
        <translation>Bereich schließen</translation>
    </message>
    <message>
        <source>New Palette from Selection…</source>
        <translation>Neue Palette aus der Auswahl …</translation>
    </message>
    <message>
        <source>List of swatches</source>
        <translation>Liste der Muster</translation>
    </message>
    <message>
        <source>Code {code}</source>
        <translation>Code {code}</translation>
    </message>
    <message>
        <source>Flat colour, {model}</source>
        <translation>Flache Farbe, {model}</translation>
    </message>
    <message>
        <source>ΔE00 to the search target: {value}</source>
        <translation>ΔE00 zum Suchziel: {value}</translation>
    </message>
    <message>
        <source>Tags: {tags}</source>
        <translation>Stichwörter: {tags}</translation>
    </message>
    <message>
        <source>Group: {group}</source>
        <translation>Gruppe: {group}</translation>
    </message>
    <message>
        <source>{name}, L* {L}, a* {a}, b* {b} at 45°, flop {flop}</source>
        <translation>{name}, L* {L}, a* {a}, b* {b} bei 45°, Flop {flop}</translation>
    </message>
    <message>
        <source>&amp;New Palette</source>
        <translation>&amp;Neue Palette</translation>
    </message>
    <message>
        <source>Open S&amp;ample Paints</source>
        <translation>&amp;Beispiellacke öffnen</translation>
    </message>
    <message>
        <source>Editable Cop&amp;y</source>
        <translation>Bearbeitbare Kop&amp;ie</translation>
    </message>
    <message>
        <source>Copy this palette to a new one that has no file yet</source>
        <translation>Diese Palette in eine neue kopieren, die noch keine Datei hat</translation>
    </message>
    <message>
        <source>Save A&amp;ll</source>
        <translation>A&amp;lle speichern</translation>
    </message>
    <message>
        <source>&amp;Close Palette</source>
        <translation>Palette &amp;schließen</translation>
    </message>
    <message>
        <source>Add paint</source>
        <translation>Lack hinzufügen</translation>
    </message>
    <message>
        <source>“{name}” imported with 1 note.</source>
        <translation>„{name}“ mit 1 Hinweis importiert.</translation>
    </message>
    <message>
        <source>“{name}” imported with {count} notes.</source>
        <translation>„{name}“ mit {count} Hinweisen importiert.</translation>
    </message>
    <message>
        <source>Choose CMYK Profile…</source>
        <translation>CMYK-Profil wählen …</translation>
    </message>
    <message>
        <source>The palette stays in the library; nothing else has changed.</source>
        <translation>Die Palette bleibt in der Bibliothek; sonst hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>The open palette is unchanged.</source>
        <translation>Die offene Palette ist unverändert.</translation>
    </message>
    <message>
        <source>“{name}” was changed by another program.</source>
        <translation>„{name}“ wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Reload loads the current file. It can be undone.</source>
        <translation>„Neu laden“ lädt die jetzige Datei. Es lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meine behalten</translation>
    </message>
    <message>
        <source>You have unsaved changes. Merge combines both versions; Reload discards yours. Both can be undone.</source>
        <translation>Es gibt ungespeicherte Änderungen. „Zusammenführen“ vereint beide Fassungen; „Neu laden“ verwirft die eigene. Beides lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Von der Platte neu laden</translation>
    </message>
    <message>
        <source>Merge with file</source>
        <translation>Mit der Datei zusammenführen</translation>
    </message>
    <message>
        <source>File merged with 1 conflict; your version was kept.</source>
        <translation>Datei mit 1 Konflikt zusammengeführt; die eigene Fassung wurde behalten.</translation>
    </message>
    <message>
        <source>File merged with {count} conflicts; your version was kept.</source>
        <translation>Datei mit {count} Konflikten zusammengeführt; die eigene Fassung wurde behalten.</translation>
    </message>
    <message>
        <source>File merged with your changes.</source>
        <translation>Datei mit den eigenen Änderungen zusammengeführt.</translation>
    </message>
    <message>
        <source>Library: palettes, groups and tags</source>
        <translation>Bibliothek: Paletten, Gruppen und Stichwörter</translation>
    </message>
    <message>
        <source>Not saved to a file</source>
        <translation>Nicht in einer Datei gespeichert</translation>
    </message>
    <message>
        <source>Comes with the suite: read-only. Save As or drag swatches to another palette to change them.</source>
        <translation>Gehört zur Suite: schreibgeschützt. Zum Ändern unter anderem Namen speichern oder Muster in eine andere Palette ziehen.</translation>
    </message>
    <message>
        <source>{file}
Not loaded; select it to load it.</source>
        <translation>{file}
Nicht geladen; zum Laden wählen.</translation>
    </message>
    <message>
        <source>{file}
Unsaved changes.</source>
        <translation>{file}
Ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Ungespeicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>a* b* L*</source>
        <translation>a* b* L*</translation>
    </message>
    <message>
        <source>All swatches in three dimensions. Left drag rotates, Ctrl+left drag selects</source>
        <translation>Alle Muster in drei Dimensionen. Ziehen links dreht, Strg+Ziehen links wählt</translation>
    </message>
    <message>
        <source>Flop over L*</source>
        <translation>Flop über L*</translation>
    </message>
    <message>
        <source>Flop index over lightness at 45°. Left drag selects</source>
        <translation>Flop-Index über der Helligkeit bei 45°. Ziehen links wählt</translation>
    </message>
    <message>
        <source>a* b*</source>
        <translation>a* b*</translation>
    </message>
    <message>
        <source>b* over a* at 45°. Left drag selects</source>
        <translation>b* über a* bei 45°. Ziehen links wählt</translation>
    </message>
    <message>
        <source>Gloss over flop</source>
        <translation>Glanz über Flop</translation>
    </message>
    <message>
        <source>Gloss at 20° over flop index. Left drag selects</source>
        <translation>Glanz bei 20° über dem Flop-Index. Ziehen links wählt</translation>
    </message>
    <message>
        <source>Type of map</source>
        <translation>Art der Karte</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Left drag selects swatches with a lasso. Ctrl adds to the selection, Alt removes</source>
        <translation>Ziehen links wählt Muster mit einem Lasso. Strg fügt zur Auswahl hinzu, Alt nimmt heraus</translation>
    </message>
    <message>
        <source>Colour &amp;Map</source>
        <translation>Farb&amp;karte</translation>
    </message>
    <message>
        <source>Fra&amp;me All in Map</source>
        <translation>Alles in der Karte &amp;einrahmen</translation>
    </message>
    <message>
        <source>No swatches to show.</source>
        <translation>Keine Muster zu zeigen.</translation>
    </message>
    <message>
        <source>The three-dimensional map needs OpenGL, which is not available here. Use one of the planes.</source>
        <translation>Die dreidimensionale Karte braucht OpenGL, das hier nicht verfügbar ist. Eine der Ebenen verwenden.</translation>
    </message>
    <message>
        <source>Lightness L* at 45°</source>
        <translation>Helligkeit L* bei 45°</translation>
    </message>
    <message>
        <source>a* at 45°, green to red</source>
        <translation>a* bei 45°, Grün bis Rot</translation>
    </message>
    <message>
        <source>b* at 45°, blue to yellow</source>
        <translation>b* bei 45°, Blau bis Gelb</translation>
    </message>
    <message>
        <source>Gloss at 20° (GU)</source>
        <translation>Glanz bei 20° (GU)</translation>
    </message>
    <message>
        <source>Two-dimensional colour map</source>
        <translation>Zweidimensionale Farbkarte</translation>
    </message>
    <message>
        <source>Three-dimensional colour map</source>
        <translation>Dreidimensionale Farbkarte</translation>
    </message>
    <message>
        <source>CIE hue angle at 45°. A range from 330° to 30° passes through 0°</source>
        <translation>CIE-Bunttonwinkel bei 45°. Ein Bereich von 330° bis 30° geht durch 0°</translation>
    </message>
    <message>
        <source>CIE L* at 45°</source>
        <translation>CIE L* bei 45°</translation>
    </message>
    <message>
        <source>CIE C* at 45°</source>
        <translation>CIE C* bei 45°</translation>
    </message>
    <message>
        <source>Flop index from 15°, 45° and 110° (0: solid)</source>
        <translation>Flop-Index aus 15°, 45° und 110° (0: Uni)</translation>
    </message>
    <message>
        <source>Gloss at 20° in gloss units</source>
        <translation>Glanz bei 20° in Glanzeinheiten</translation>
    </message>
    <message>
        <source>Duplicates within</source>
        <translation>Doppelte innerhalb</translation>
    </message>
    <message>
        <source>Show only swatches within this ΔE00 of another at every angle, by group</source>
        <translation>Nur Muster zeigen, die an jedem Winkel innerhalb dieses ΔE00 von einem anderen liegen, nach Gruppen</translation>
    </message>
    <message>
        <source>Duplicate tolerance</source>
        <translation>Toleranz für Doppelte</translation>
    </message>
    <message>
        <source>Name of the palette or group</source>
        <translation>Name der Palette oder Gruppe</translation>
    </message>
    <message>
        <source>Colour that marks the palette or group in the library</source>
        <translation>Farbe, die die Palette oder Gruppe in der Bibliothek kennzeichnet</translation>
    </message>
    <message>
        <source>Colour of the palette or group</source>
        <translation>Farbe der Palette oder Gruppe</translation>
    </message>
    <message>
        <source>No colour</source>
        <translation>Keine Farbe</translation>
    </message>
    <message>
        <source>Notes of the palette or group</source>
        <translation>Notizen der Palette oder Gruppe</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Colour of the Palette</source>
        <translation>Farbe der Palette</translation>
    </message>
    <message>
        <source>{name}, from</source>
        <translation>{name}, von</translation>
    </message>
    <message>
        <source>{name}, to</source>
        <translation>{name}, bis</translation>
    </message>
    <message>
        <source>Space switches the handle; double-click clears the filter.</source>
        <translation>Die Leertaste wechselt den Griff; ein Doppelklick hebt den Filter auf.</translation>
    </message>
    <message>
        <source>Measured colours</source>
        <translation>Gemessene Farben</translation>
    </message>
    <message>
        <source>comma-separated</source>
        <translation>kommagetrennt</translation>
    </message>
    <message>
        <source>Search terms, comma-separated. With several swatches, +word adds and -word removes a tag.</source>
        <translation>Suchbegriffe, kommagetrennt. Bei mehreren Mustern fügt +Wort ein Stichwort hinzu, -Wort entfernt es.</translation>
    </message>
    <message>
        <source>No swatch selected. Click one, or drag around several.</source>
        <translation>Kein Muster gewählt. Eines anklicken oder mehrere mit Ziehen umfahren.</translation>
    </message>
    <message>
        <source>{count} swatches selected. Edits apply to all.</source>
        <translation>{count} Muster gewählt. Änderungen gelten für alle.</translation>
    </message>
    <message>
        <source>{count} swatches selected.</source>
        <translation>{count} Muster ausgewählt.</translation>
    </message>
    <message>
        <source>Palette order</source>
        <translation>Palettenfolge</translation>
    </message>
    <message>
        <source>Hue path</source>
        <translation>Bunttonpfad</translation>
    </message>
    <message>
        <source>Nearest first</source>
        <translation>Nächste zuerst</translation>
    </message>
    <message>
        <source>Sphere in the light booth</source>
        <translation>Kugel in der Lichtkabine</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Blech</translation>
    </message>
    <message>
        <source>Curved panel in the light booth</source>
        <translation>Gewölbtes Blech in der Lichtkabine</translation>
    </message>
    <message>
        <source>Flop from 15° (left) to 110° (right)</source>
        <translation>Flop von 15° (links) bis 110° (rechts)</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Plättchen</translation>
    </message>
    <message>
        <source>Measured colours at 15°, 45° and 110° as flat chips</source>
        <translation>Gemessene Farben bei 15°, 45° und 110° als flache Plättchen</translation>
    </message>
    <message>
        <source>Search names, codes, tags, notes</source>
        <translation>Muster durchsuchen</translation>
    </message>
    <message>
        <source>Search names, codes, tags and notes</source>
        <translation>Namen, Codes, Stichwörter und Notizen durchsuchen</translation>
    </message>
    <message>
        <source>Every word must occur in name, code, tags, notes or group (Ctrl+F)</source>
        <translation>Jedes Wort muss in Name, Code, Stichwörtern, Notizen oder Gruppe vorkommen (Strg+F)</translation>
    </message>
    <message>
        <source>Order of the swatches</source>
        <translation>Reihenfolge der Muster</translation>
    </message>
    <message>
        <source>Order of the swatches. Swatches can be moved by hand in palette order</source>
        <translation>Reihenfolge der Muster. In der Palettenfolge lassen sie sich von Hand verschieben</translation>
    </message>
    <message>
        <source>Light for all swatches</source>
        <translation>Licht für alle Muster</translation>
    </message>
    <message>
        <source>List with columns</source>
        <translation>Liste mit Spalten</translation>
    </message>
    <message>
        <source>List with columns (5)</source>
        <translation>Liste mit Spalten (5)</translation>
    </message>
    <message>
        <source>Swatch size in pixels</source>
        <translation>Größe der Muster in Pixeln</translation>
    </message>
    <message>
        <source>Descending; click for ascending</source>
        <translation>Absteigend; Klick für aufsteigend</translation>
    </message>
    <message>
        <source>Ascending; click for descending</source>
        <translation>Aufsteigend; Klick für absteigend</translation>
    </message>
    <message>
        <source>Swatch size: {size} pixels (Ctrl+wheel)</source>
        <translation>Größe der Muster: {size} Pixel (Strg+Mausrad)</translation>
    </message>
    <message>
        <source>{count} pictures pending</source>
        <translation>{count} Bilder ausstehend</translation>
    </message>
    <message>
        <source>The swatches cannot be rendered here.</source>
        <translation>Die Muster können hier nicht gerendert werden.</translation>
    </message>
    <message>
        <source>Measured colours are shown instead; everything else works.</source>
        <translation>Stattdessen werden gemessene Farben gezeigt; alles andere funktioniert.</translation>
    </message>
    <message>
        <source>The rendering process ended repeatedly. Choose another form or light.</source>
        <translation>Der Renderprozess endete wiederholt. Eine andere Form oder ein anderes Licht wählen.</translation>
    </message>
    <message>
        <source>The rendering process ended while rendering this paint.</source>
        <translation>Der Renderprozess endete beim Rendern dieses Lacks.</translation>
    </message>
    <message>
        <source>The pictures cannot be rendered: {reason}.</source>
        <translation>Die Bilder können nicht gerendert werden: {reason}.</translation>
    </message>
    <message>
        <source>Swatch</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Palette or Group</source>
        <translation>Palette oder Gruppe</translation>
    </message>
    <message>
        <source>Swatches shown and selected</source>
        <translation>Gezeigte und gewählte Muster</translation>
    </message>
    <message>
        <source>Visible pictures still pending</source>
        <translation>Noch ausstehende sichtbare Bilder</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Notes on the colours shown</source>
        <translation>Hinweise zu den gezeigten Farben</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>¾ view</source>
        <translation>¾-Ansicht</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Fill the picture with the surface (F)</source>
        <translation>Das Bild mit der Oberfläche füllen (F)</translation>
    </message>
    <message>
        <source>View: {view} ({key})</source>
        <translation>Ansicht: {view} ({key})</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>{meaning}; negative reverses. Space on the picture starts and stops it</source>
        <translation>{meaning}; negativ kehrt um. Die Leertaste auf dem Bild startet und hält an</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard at full resolution</source>
        <translation>Das Bild in voller Auflösung in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>&amp;Open Paint…</source>
        <translation>&amp;Lack öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Environment…</source>
        <translation>&amp;Umgebung öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Surface…</source>
        <translation>&amp;Oberfläche öffnen …</translation>
    </message>
    <message>
        <source>Open Pa&amp;lette…</source>
        <translation>&amp;Palette öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;View…</source>
        <translation>&amp;Ansicht öffnen …</translation>
    </message>
    <message>
        <source>&amp;Save View</source>
        <translation>&amp;Ansicht speichern</translation>
    </message>
    <message>
        <source>Camera, light and all settings</source>
        <translation>Kamera, Licht und alle Einstellungen</translation>
    </message>
    <message>
        <source>Save View &amp;As…</source>
        <translation>Ansicht speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the picture as PNG at full resolution, with paint and settings as metadata</source>
        <translation>Das Bild als PNG in voller Auflösung speichern, mit Lack und Einstellungen als Metadaten</translation>
    </message>
    <message>
        <source>Save T&amp;raced Picture…</source>
        <translation>&amp;Strahlverfolgtes Bild speichern …</translation>
    </message>
    <message>
        <source>Save the traced picture as EXR with the variance of each pixel</source>
        <translation>Das strahlverfolgte Bild als EXR mit der Varianz jedes Pixels speichern</translation>
    </message>
    <message>
        <source>A picture of any size, as PNG or EXR</source>
        <translation>Ein Bild beliebiger Größe, als PNG oder EXR</translation>
    </message>
    <message>
        <source>Export &amp;Turntable…</source>
        <translation>&amp;Drehteller exportieren …</translation>
    </message>
    <message>
        <source>One turn of the object, as a video or a folder of pictures</source>
        <translation>Eine Umdrehung des Objekts, als Video oder als Ordner mit Bildern</translation>
    </message>
    <message>
        <source>Export &amp;Contact Sheet…</source>
        <translation>&amp;Kontaktbogen exportieren …</translation>
    </message>
    <message>
        <source>All paints of a palette or a folder in this light</source>
        <translation>Alle Lacke einer Palette oder eines Ordners in diesem Licht</translation>
    </message>
    <message>
        <source>S&amp;tudio</source>
        <translation>S&amp;tudio</translation>
    </message>
    <message>
        <source>Recent &amp;Paints</source>
        <translation>Zuletzt geöffnete &amp;Lacke</translation>
    </message>
    <message>
        <source>Export &amp;Picture…</source>
        <translation>&amp;Bild exportieren …</translation>
    </message>
    <message>
        <source>There is no traced picture yet: choose Ray-traced or Path-traced in the tab Export</source>
        <translation>Es gibt noch kein strahlverfolgtes Bild: im Reiter Export „Strahlverfolgt“ oder „Pfadverfolgt“ wählen</translation>
    </message>
    <message>
        <source>Recent Pale&amp;ttes</source>
        <translation>Zuletzt geöffnete &amp;Paletten</translation>
    </message>
    <message>
        <source>Recent Vie&amp;ws</source>
        <translation>Zuletzt geöffnete &amp;Ansichten</translation>
    </message>
    <message>
        <source>Recent E&amp;nvironments</source>
        <translation>Zuletzt geöffnete &amp;Umgebungen</translation>
    </message>
    <message>
        <source>Recent S&amp;urfaces</source>
        <translation>Zuletzt geöffnete &amp;Oberflächen</translation>
    </message>
    <message>
        <source>A picture, a turntable or a contact sheet, with a preview</source>
        <translation>Ein Bild, ein Drehteller oder ein Kontaktbogen, mit Vorschau</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportieren …</translation>
    </message>
    <message>
        <source>Export &amp;As</source>
        <translation>Exportieren &amp;als</translation>
    </message>
    <message>
        <source>&amp;Save Picture…</source>
        <translation>Bild &amp;speichern …</translation>
    </message>
    <message>
        <source>View: {view}, framing the surface</source>
        <translation>Ansicht: {view}, Oberfläche eingerahmt</translation>
    </message>
    <message>
        <source>View: {view}</source>
        <translation>Ansicht: {view}</translation>
    </message>
    <message>
        <source>&amp;Frame Surface</source>
        <translation>Oberfläche &amp;einrahmen</translation>
    </message>
    <message>
        <source>Fill the picture with the surface</source>
        <translation>Das Bild mit der Oberfläche füllen</translation>
    </message>
    <message>
        <source>&amp;Turntable</source>
        <translation>&amp;Drehteller</translation>
    </message>
    <message>
        <source>Rotate the surface in front of camera and light</source>
        <translation>Die Oberfläche vor Kamera und Licht drehen</translation>
    </message>
    <message>
        <source>&amp;Environment</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>S&amp;urface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>T&amp;one Curve</source>
        <translation>Tonwertk&amp;urve</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>Figures over the &amp;Picture</source>
        <translation>Zahlen über dem &amp;Bild</translation>
    </message>
    <message>
        <source>Frame time, lobes, tone curve and readout</source>
        <translation>Bildzeit, Keulen, Tonwertkurve und Messwerte am Zeiger</translation>
    </message>
    <message>
        <source>&amp;Renderer</source>
        <translation>&amp;Renderer</translation>
    </message>
    <message>
        <source>Ray-traced: {quality}</source>
        <translation>Strahlverfolgt: {quality}</translation>
    </message>
    <message>
        <source>&amp;Stop Refining</source>
        <translation>Verfeinern an&amp;halten</translation>
    </message>
    <message>
        <source>Keep the picture as it is</source>
        <translation>Das Bild lassen, wie es ist</translation>
    </message>
    <message>
        <source>&amp;Resume Refining</source>
        <translation>Verfeinern &amp;fortsetzen</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>Start or Stop &amp;Blinking</source>
        <translation>&amp;Blinken starten oder anhalten</translation>
    </message>
    <message>
        <source>Alternate between A and B; again to return to the previous mode</source>
        <translation>Zwischen A und B wechseln; noch einmal führt zur vorigen Art zurück</translation>
    </message>
    <message>
        <source>&amp;Switch and Stay</source>
        <translation>&amp;Umschalten und bleiben</translation>
    </message>
    <message>
        <source>Switch between A and B manually</source>
        <translation>Von Hand zwischen A und B umschalten</translation>
    </message>
    <message>
        <source>&amp;Freeze A as B</source>
        <translation>A als B &amp;festhalten</translation>
    </message>
    <message>
        <source>Keep the current paint as B</source>
        <translation>Den jetzigen Lack als B behalten</translation>
    </message>
    <message>
        <source>Show the paint that is being edited in Designer</source>
        <translation>Den Lack zeigen, der in Designer bearbeitet wird</translation>
    </message>
    <message>
        <source>&amp;Next Paint</source>
        <translation>&amp;Nächster Lack</translation>
    </message>
    <message>
        <source>&amp;Previous Paint</source>
        <translation>&amp;Voriger Lack</translation>
    </message>
    <message>
        <source>In the open palette or the shipped paints</source>
        <translation>In der offenen Palette oder den Beispiellacken</translation>
    </message>
    <message>
        <source>Open &amp;Shipped Paint</source>
        <translation>&amp;Beispiellack öffnen</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Einrahmen</translation>
    </message>
    <message>
        <source>of the light, before the tone curve</source>
        <translation>des Lichts, vor der Tonwertkurve</translation>
    </message>
    <message>
        <source>of the picture, as shown</source>
        <translation>des Bildes, wie gezeigt</translation>
    </message>
    <message>
        <source>Choose another paint as B, or freeze the current one.</source>
        <translation>Einen anderen Lack als B wählen oder den jetzigen festhalten.</translation>
    </message>
    <message>
        <source>No second paint is selected.</source>
        <translation>Kein zweiter Lack ist gewählt.</translation>
    </message>
    <message>
        <source>Choose one in the tab Compare, or freeze the current paint as B.</source>
        <translation>Im Reiter Vergleich einen wählen, oder den aktuellen Lack als B einfrieren.</translation>
    </message>
    <message>
        <source>Freeze A as B</source>
        <translation>A als B festhalten</translation>
    </message>
    <message>
        <source>This paint in real time</source>
        <translation>Dieser Lack in Echtzeit</translation>
    </message>
    <message>
        <source>B is the same paint in real time: all differences come from the renderer</source>
        <translation>B ist derselbe Lack in Echtzeit: Alle Unterschiede kommen vom Renderer</translation>
    </message>
    <message>
        <source>light (linear)</source>
        <translation>Licht (linear)</translation>
    </message>
    <message>
        <source>display colours, with its own tone curve</source>
        <translation>Anzeigefarben, mit eigener Tonwertkurve</translation>
    </message>
    <message>
        <source>B is a picture of {columns} × {rows} pixels, {what}; it fits by its width</source>
        <translation>B ist ein Bild von {columns} × {rows} Pixeln, {what}; es wird in der Breite eingepasst</translation>
    </message>
    <message>
        <source>B: fit: maximum ΔE00 {worst:.2f} at the measured angles</source>
        <translation>B: Anpassung: größtes ΔE00 {worst:.2f} an den gemessenen Winkeln</translation>
    </message>
    <message>
        <source>{name} (frozen)</source>
        <translation>{name} (festgehalten)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>Wischen</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>Blinken</translation>
    </message>
    <message>
        <source>Difference (ΔE00)</source>
        <translation>Differenz (ΔE00)</translation>
    </message>
    <message>
        <source>Only the current paint</source>
        <translation>Nur der jetzige Lack</translation>
    </message>
    <message>
        <source>Each has half the picture with its own framing</source>
        <translation>Jeder hat die halbe Breite mit eigenem Bildausschnitt</translation>
    </message>
    <message>
        <source>One picture: A left of the line, B right of it; drag the line</source>
        <translation>Ein Bild: A links der Linie, B rechts davon; die Linie lässt sich ziehen</translation>
    </message>
    <message>
        <source>Alternately in the same place</source>
        <translation>Abwechselnd an derselben Stelle</translation>
    </message>
    <message>
        <source>Colour difference of each pixel on a colour scale</source>
        <translation>Farbabstand jedes Pixels auf einer Farbskala</translation>
    </message>
    <message>
        <source>Exposed radiance before the tone curve; radiance 1 has L* = 100</source>
        <translation>Belichtete Strahldichte vor der Tonwertkurve; Strahldichte 1 hat L* = 100</translation>
    </message>
    <message>
        <source>Displayed colours after the tone curve</source>
        <translation>Angezeigte Farben nach der Tonwertkurve</translation>
    </message>
    <message>
        <source>Open a paint, a measured file or a picture (.exr, .png) as B</source>
        <translation>Einen Lack, eine Messdatei oder ein Bild (.exr, .png) als B öffnen</translation>
    </message>
    <message>
        <source>Keep the current paint as B while A changes (Ctrl+B)</source>
        <translation>Den jetzigen Lack als B behalten, während A sich ändert (Strg+B)</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>Trennlinie</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Comparison of A and B; press B to blink</source>
        <translation>Vergleich von A und B; B drücken zum Blinken</translation>
    </message>
    <message>
        <source>Second (B)</source>
        <translation>Zweiter (B)</translation>
    </message>
    <message>
        <source>Paint or picture that the current paint is compared with</source>
        <translation>Lack oder Bild, mit dem der jetzige Lack verglichen wird</translation>
    </message>
    <message>
        <source>Colours whose difference is shown</source>
        <translation>Farben, deren Differenz gezeigt wird</translation>
    </message>
    <message>
        <source>Paint or Measured File</source>
        <translation>Lack oder Messdatei</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Second Paint or Picture</source>
        <translation>Zweiter Lack oder Bild</translation>
    </message>
    <message>
        <source>Normal Map</source>
        <translation>Normal-Map</translation>
    </message>
    <message>
        <source>Tangent Map</source>
        <translation>Tangenten-Map</translation>
    </message>
    <message>
        <source>Open: {what}</source>
        <translation>Öffnen: {what}</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>The picture is unchanged. Choose another view.</source>
        <translation>Das Bild ist unverändert. Eine andere Ansicht wählen.</translation>
    </message>
    <message>
        <source>Choose another name or folder.</source>
        <translation>Einen anderen Namen oder Ordner wählen.</translation>
    </message>
    <message>
        <source>{file} refers to the light without its unsaved edits.</source>
        <translation>{file} verweist auf das Licht ohne dessen ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save the studio, then the view again.</source>
        <translation>Zuerst das Studio speichern, dann die Ansicht erneut.</translation>
    </message>
    <message>
        <source>Move Camera</source>
        <translation>Kamera bewegen</translation>
    </message>
    <message>
        <source>Turn Light</source>
        <translation>Licht drehen</translation>
    </message>
    <message>
        <source>Change Exposure</source>
        <translation>Belichtung ändern</translation>
    </message>
    <message>
        <source>Change Lamps</source>
        <translation>Lampen ändern</translation>
    </message>
    <message>
        <source>Change Turntable</source>
        <translation>Drehteller ändern</translation>
    </message>
    <message>
        <source>Change Materials</source>
        <translation>Materialien ändern</translation>
    </message>
    <message>
        <source>Move Divider</source>
        <translation>Trennlinie verschieben</translation>
    </message>
    <message>
        <source>Change Background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Change Background Colour</source>
        <translation>Hintergrundfarbe ändern</translation>
    </message>
    <message>
        <source>Change Clipping Marks</source>
        <translation>Übersteuerungsmarken ändern</translation>
    </message>
    <message>
        <source>Change Compare</source>
        <translation>Vergleich ändern</translation>
    </message>
    <message>
        <source>Change Environment</source>
        <translation>Umgebung ändern</translation>
    </message>
    <message>
        <source>Change Environment Layout</source>
        <translation>Projektion der Umgebung ändern</translation>
    </message>
    <message>
        <source>Change Exposure Mode</source>
        <translation>Art der Belichtung ändern</translation>
    </message>
    <message>
        <source>Change Fresnel</source>
        <translation>Fresnel ändern</translation>
    </message>
    <message>
        <source>Change Gamut Marks</source>
        <translation>Farbraummarken ändern</translation>
    </message>
    <message>
        <source>Change Lamp Shading</source>
        <translation>Lampenschattierung ändern</translation>
    </message>
    <message>
        <source>Change Light Colour</source>
        <translation>Lichtfarbe ändern</translation>
    </message>
    <message>
        <source>Change Look Up</source>
        <translation>Nachschlagen ändern</translation>
    </message>
    <message>
        <source>Change Mark Style</source>
        <translation>Stil der Marken ändern</translation>
    </message>
    <message>
        <source>Change Lens</source>
        <translation>Objektiv ändern</translation>
    </message>
    <message>
        <source>Change Relief</source>
        <translation>Relief ändern</translation>
    </message>
    <message>
        <source>Change Sparkle</source>
        <translation>Glitzern ändern</translation>
    </message>
    <message>
        <source>Change Surface</source>
        <translation>Oberfläche ändern</translation>
    </message>
    <message>
        <source>Change Surface Look</source>
        <translation>Einstellungen der Oberfläche ändern</translation>
    </message>
    <message>
        <source>Change Tone Curve</source>
        <translation>Tonwertkurve ändern</translation>
    </message>
    <message>
        <source>Change Two Tone</source>
        <translation>Zweifarbigkeit ändern</translation>
    </message>
    <message>
        <source>New folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>A paint: all paints of its folder (*.brdfpaint)</source>
        <translation>Ein Lack: alle Lacke seines Ordners (*.brdfpaint)</translation>
    </message>
    <message>
        <source>Paints of the Sheet</source>
        <translation>Lacke des Bogens</translation>
    </message>
    <message>
        <source>Wait until paint, surface and environment are loaded, then export.</source>
        <translation>Warten, bis Lack, Oberfläche und Umgebung geladen sind, dann exportieren.</translation>
    </message>
    <message>
        <source>There is no picture yet.</source>
        <translation>Noch gibt es kein Bild.</translation>
    </message>
    <message>
        <source>Save it with File ▸ Studio ▸ Save Studio, then export.</source>
        <translation>Mit Datei ▸ Studio ▸ Studio speichern sichern, dann exportieren.</translation>
    </message>
    <message>
        <source>The light has unsaved changes, which an export would not include.</source>
        <translation>Das Licht hat ungespeicherte Änderungen, die ein Export nicht enthielte.</translation>
    </message>
    <message>
        <source>Export of {file} cancelled</source>
        <translation>Export von {file} abgebrochen</translation>
    </message>
    <message>
        <source>{file}: starting</source>
        <translation>{file}: wird begonnen</translation>
    </message>
    <message>
        <source>{file} was exported without {count} of its paints.</source>
        <translation>{file} wurde ohne {count} der Lacke exportiert.</translation>
    </message>
    <message>
        <source>Picture on screen</source>
        <translation>Bild auf dem Schirm</translation>
    </message>
    <message>
        <source>Traced picture</source>
        <translation>Strahlverfolgtes Bild</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Blende</translation>
    </message>
    <message>
        <source>All sharp</source>
        <translation>Alles scharf</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Middle of the picture</source>
        <translation>Bildmitte</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Verschluss</translation>
    </message>
    <message>
        <source>Palette or folder</source>
        <translation>Palette oder Ordner</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>Lacke</translation>
    </message>
    <message>
        <source>Click to show; drag onto the picture or into a palette</source>
        <translation>Klicken zeigt den Lack; ziehbar auf das Bild oder in eine Palette</translation>
    </message>
    <message>
        <source>Compare with {name} (also Shift click)</source>
        <translation>Mit {name} vergleichen (auch Umschalt-Klick)</translation>
    </message>
    <message>
        <source>Click to show, its scales to compare; drag onto the picture or into a palette</source>
        <translation>Klicken zeigt den Lack, seine Waage vergleicht; ziehbar auf das Bild oder in eine Palette</translation>
    </message>
    <message>
        <source>List the paints of a palette</source>
        <translation>Lacke einer Palette auflisten</translation>
    </message>
    <message>
        <source>Colour space; the ICC profile is embedded in the file</source>
        <translation>Farbraum; das ICC-Profil wird in die Datei eingebettet</translation>
    </message>
    <message>
        <source>Per pixel, limited by the graphics card</source>
        <translation>Je Pixel, durch die Grafikkarte begrenzt</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Proben je Pixel</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Frames per turn</source>
        <translation>Bilder je Umdrehung</translation>
    </message>
    <message>
        <source>Frames per second of a video</source>
        <translation>Bilder je Sekunde eines Videos</translation>
    </message>
    <message>
        <source>Motion blur: how long the shutter is open, 360° for the whole time of a frame</source>
        <translation>Bewegungsunschärfe: wie lange der Verschluss offen ist, 360° für die ganze Zeit eines Bildes</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Radiance before exposure and tone curve, in the primaries stated in the file</source>
        <translation>Strahldichte vor Belichtung und Tonwertkurve, in den Primärfarben, die in der Datei stehen</translation>
    </message>
    <message>
        <source>sRGB; an even width and height</source>
        <translation>sRGB; gerade Breite und Höhe</translation>
    </message>
    <message>
        <source>Contact sheet</source>
        <translation>Kontaktbogen</translation>
    </message>
    <message>
        <source>PNG, 8 bits</source>
        <translation>PNG, 8 Bit</translation>
    </message>
    <message>
        <source>PNG, 16 bits</source>
        <translation>PNG, 16 Bit</translation>
    </message>
    <message>
        <source>EXR, radiance, 32 bits</source>
        <translation>EXR, Strahldichte, 32 Bit</translation>
    </message>
    <message>
        <source>EXR, radiance, 16 bits</source>
        <translation>EXR, Strahldichte, 16 Bit</translation>
    </message>
    <message>
        <source>MP4 video</source>
        <translation>MP4-Video</translation>
    </message>
    <message>
        <source>WebM video</source>
        <translation>WebM-Video</translation>
    </message>
    <message>
        <source>Folder of PNG, 8 bits</source>
        <translation>Ordner mit PNG, 8 Bit</translation>
    </message>
    <message>
        <source>Folder of PNG, 16 bits</source>
        <translation>Ordner mit PNG, 16 Bit</translation>
    </message>
    <message>
        <source>Wait until paint, surface and environment are loaded, then save.</source>
        <translation>Warten, bis Lack, Oberfläche und Umgebung geladen sind, dann speichern.</translation>
    </message>
    <message>
        <source>pictures are written as PNG; give a name that ends in {ending}</source>
        <translation>Bilder werden als PNG geschrieben; der Name muss auf {ending} enden</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>Farbe wählen</translation>
    </message>
    <message>
        <source>Above the horizontal plane</source>
        <translation>Über der waagerechten Ebene</translation>
    </message>
    <message>
        <source>About the direction in which the lamp shines</source>
        <translation>Um die Richtung, in die die Lampe leuchtet</translation>
    </message>
    <message>
        <source>Around the y axis, 0 on +z</source>
        <translation>Um die y-Achse, 0 auf +z</translation>
    </message>
    <message>
        <source>Each step doubles the light</source>
        <translation>Jede Stufe verdoppelt das Licht</translation>
    </message>
    <message>
        <source>Factor on all lengths of the mesh</source>
        <translation>Faktor auf alle Längen des Netzes</translation>
    </message>
    <message>
        <source>Largest distance of a triangle from the CAD surface that it stands for</source>
        <translation>Größter Abstand eines Dreiecks von der CAD-Fläche, für die es steht</translation>
    </message>
    <message>
        <source>Factor on the environment&apos;s light; 0: the lamps alone</source>
        <translation>Faktor auf das Licht der Umgebung; 0: die Lampen allein</translation>
    </message>
    <message>
        <source>Factor on the light of single flakes; 1: as density and size say</source>
        <translation>Faktor auf das Licht einzelner Flakes; 1: wie aus Dichte und Größe folgt</translation>
    </message>
    <message>
        <source>Factor on the normal map&apos;s slopes</source>
        <translation>Faktor auf die Neigungen der Normal-Map</translation>
    </message>
    <message>
        <source>Haze: 2 very clear, 3 clear, 6 hazy</source>
        <translation>Trübung der Luft: 2 sehr klar, 3 klar, 6 dunstig</translation>
    </message>
    <message>
        <source>How often a second a blink changes over</source>
        <translation>Wie oft in der Sekunde das Blinken wechselt</translation>
    </message>
    <message>
        <source>Illuminance over π, in the units of the environment: a white surface that faces the lamp, at 1 m from a point lamp, gets this radiance</source>
        <translation>Beleuchtungsstärke durch π, in den Einheiten der Umgebung: Eine weiße Fläche, die zur Lampe zeigt, bei einer Punktlampe in 1 m Abstand, erhält diese Strahldichte</translation>
    </message>
    <message>
        <source>Across the disc of a directional lamp, the sun&apos;s is 0.53; 0: sharp shadows</source>
        <translation>Durchmesser der Scheibe einer gerichteten Lampe, die Sonne hat 0,53; 0: scharfe Schatten</translation>
    </message>
    <message>
        <source>By which the object turns while the shutter is open</source>
        <translation>Um den sich das Objekt dreht, während der Verschluss offen ist</translation>
    </message>
    <message>
        <source>Focal length over diameter of the lens&apos;s opening; 0: all is sharp</source>
        <translation>Brennweite durch Durchmesser der Öffnung des Objektivs; 0: alles ist scharf</translation>
    </message>
    <message>
        <source>From the camera to the plane that is sharp</source>
        <translation>Von der Kamera zur scharfen Ebene</translation>
    </message>
    <message>
        <source>Of a point lamp, a ball; 0: a point, whose shadows are sharp</source>
        <translation>Einer Punktlampe, einer Kugel; 0: ein Punkt mit scharfen Schatten</translation>
    </message>
    <message>
        <source>Of the lamp&apos;s light, on the locus of daylight</source>
        <translation>Des Lampenlichts, auf der Kurve des Tageslichts</translation>
    </message>
    <message>
        <source>Of the middle of the scene</source>
        <translation>Der Mitte der Szene</translation>
    </message>
    <message>
        <source>Of the room, from wall to wall</source>
        <translation>Des Raums, von Wand zu Wand</translation>
    </message>
    <message>
        <source>Of the sun above the horizon</source>
        <translation>Der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Of the sun, from +z towards +x</source>
        <translation>Der Sonne, von +z nach +x</translation>
    </message>
    <message>
        <source>On a 36 mm sensor</source>
        <translation>Auf einem Sensor von 36 mm</translation>
    </message>
    <message>
        <source>Root mean square slope of the coat&apos;s waviness</source>
        <translation>Quadratisches Mittel der Neigung der Klarlackwellen</translation>
    </message>
    <message>
        <source>Share of the light that is given back</source>
        <translation>Anteil des Lichts, der zurückgegeben wird</translation>
    </message>
    <message>
        <source>Share of the light that the ground gives back</source>
        <translation>Anteil des Lichts, den der Boden zurückgibt</translation>
    </message>
    <message>
        <source>Share of the width that shows the first</source>
        <translation>Anteil der Breite, der den ersten zeigt</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Speed of the turntable, counter-clockwise seen from above</source>
        <translation>Geschwindigkeit des Drehtellers, gegen den Uhrzeigersinn von oben gesehen</translation>
    </message>
    <message>
        <source>The brightest lights of the environment, in which flakes glint</source>
        <translation>Die hellsten Lichter der Umgebung, in denen Flakes glitzern</translation>
    </message>
    <message>
        <source>The colour difference at the end of the colour scale</source>
        <translation>Der Farbabstand am Ende der Farbskala</translation>
    </message>
    <message>
        <source>Turns the light counter-clockwise, seen from above</source>
        <translation>Dreht das Licht gegen den Uhrzeigersinn, von oben gesehen</translation>
    </message>
    <message>
        <source>Typical distance from crest to crest of the orange peel</source>
        <translation>Üblicher Abstand von Kamm zu Kamm der Orangenhaut</translation>
    </message>
    <message>
        <source>What one tile of the map covers</source>
        <translation>Was eine Kachel der Karte bedeckt</translation>
    </message>
    <message>
        <source>What one tile of the mask covers</source>
        <translation>Was eine Kachel der Maske bedeckt</translation>
    </message>
    <message>
        <source>Move Lamps</source>
        <translation>Lampen bewegen</translation>
    </message>
    <message>
        <source>Exposure, locked</source>
        <translation>Belichtung, fest</translation>
    </message>
    <message>
        <source>{total:+.1f} EV automatic</source>
        <translation>{total:+.1f} EV automatisch</translation>
    </message>
    <message>
        <source>Exposure: automatic value plus {value:+.1f} EV</source>
        <translation>Belichtung: automatischer Wert plus {value:+.1f} EV</translation>
    </message>
    <message>
        <source>point lamp {number}</source>
        <translation>Punktlampe {number}</translation>
    </message>
    <message>
        <source>lamp {number}, elevation {elevation:.0f}°</source>
        <translation>Lampe {number}, Höhenwinkel {elevation:.0f}°</translation>
    </message>
    <message>
        <source>the main light, elevation {elevation:.0f}°, azimuth {azimuth:.0f}° ({share:.0f} % of the environment)</source>
        <translation>dem Hauptlicht, Höhenwinkel {elevation:.0f}°, Azimut {azimuth:.0f}° ({share:.0f} % der Umgebung)</translation>
    </message>
    <message>
        <source>Histogram of the light</source>
        <translation>Histogramm des Lichts</translation>
    </message>
    <message>
        <source>Share of the sphere by log2 of luminance; {shares}</source>
        <translation>Anteil der Kugel nach log2 der Leuchtdichte; {shares}</translation>
    </message>
    <message>
        <source>luminance, by stops</source>
        <translation>Leuchtdichte, in Blenden</translation>
    </message>
    <message>
        <source>Luminance {low:.3g} to {high:.3g}: {share:.3g} % of the sphere</source>
        <translation>Leuchtdichte {low:.3g} bis {high:.3g}: {share:.3g} % der Kugel</translation>
    </message>
    <message>
        <source>partly black</source>
        <translation>teilweise schwarz</translation>
    </message>
    <message>
        <source>{stops:.1f} stops</source>
        <translation>{stops:.1f} Blenden</translation>
    </message>
    <message>
        <source>No dominant light source</source>
        <translation>Keine vorherrschende Lichtquelle</translation>
    </message>
    <message>
        <source>Main light: elevation {elevation:.0f}°, azimuth {azimuth:.0f}°, {share:.0f} % of total</source>
        <translation>Hauptlicht: Höhenwinkel {elevation:.0f}°, Azimut {azimuth:.0f}°, {share:.0f} % des Ganzen</translation>
    </message>
    <message>
        <source>Luminance: mean {mean:.3g}, maximum {largest:.3g}</source>
        <translation>Leuchtdichte: Mittel {mean:.3g}, Maximum {largest:.3g}</translation>
    </message>
    <message>
        <source>Dynamic range {reach}</source>
        <translation>Dynamikumfang {reach}</translation>
    </message>
    <message>
        <source>Horizontal illuminance {value:.3g}</source>
        <translation>Horizontale Beleuchtungsstärke {value:.3g}</translation>
    </message>
    <message>
        <source>{columns} × {rows} pixels</source>
        <translation>{columns} × {rows} Pixel</translation>
    </message>
    <message>
        <source>Draft; full quality follows after editing.</source>
        <translation>Entwurf; volle Güte folgt nach der Bearbeitung.</translation>
    </message>
    <message>
        <source>Refining reflections {what}</source>
        <translation>Spiegelungen werden verfeinert {what}</translation>
    </message>
    <message>
        <source>Reflections incomplete {what}. Select the light again to finish.</source>
        <translation>Spiegelungen unvollständig {what}. Das Licht erneut wählen, um sie fertigzustellen.</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Latitude-longitude</source>
        <translation>Länge und Breite</translation>
    </message>
    <message>
        <source>Cube, horizontal cross</source>
        <translation>Würfel, waagerechtes Kreuz</translation>
    </message>
    <message>
        <source>Cube, vertical cross</source>
        <translation>Würfel, senkrechtes Kreuz</translation>
    </message>
    <message>
        <source>Cube, faces side by side</source>
        <translation>Würfel, Seiten nebeneinander</translation>
    </message>
    <message>
        <source>Cube, faces one below another</source>
        <translation>Würfel, Seiten untereinander</translation>
    </message>
    <message>
        <source>Cube of OpenEXR</source>
        <translation>Würfel von OpenEXR</translation>
    </message>
    <message>
        <source>Angular probe</source>
        <translation>Winkelsonde</translation>
    </message>
    <message>
        <source>Mirror ball</source>
        <translation>Spiegelkugel</translation>
    </message>
    <message>
        <source>Dome, upper half</source>
        <translation>Kuppel, obere Hälfte</translation>
    </message>
    <message>
        <source>Environment, blurred</source>
        <translation>Umgebung, unscharf</translation>
    </message>
    <message>
        <source>Neutral grey</source>
        <translation>Neutralgrau</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Open an environment file (.exr, .hdr, .brdfstudio)</source>
        <translation>Eine Umgebungsdatei öffnen (.exr, .hdr, .brdfstudio)</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotates the light; also Alt drag in the picture</source>
        <translation>Dreht das Licht; auch durch Ziehen mit Alt im Bild</translation>
    </message>
    <message>
        <source>What is seen behind the form</source>
        <translation>Was hinter der Form zu sehen ist</translation>
    </message>
    <message>
        <source>Bright highlights have a halo, as in the eye</source>
        <translation>Helle Glanzlichter haben einen Hof wie im Auge</translation>
    </message>
    <message>
        <source>Colour of the background</source>
        <translation>Farbe des Hintergrunds</translation>
    </message>
    <message>
        <source>Colour of a plain background</source>
        <translation>Farbe eines einfarbigen Hintergrunds</translation>
    </message>
    <message>
        <source>Mapping of radiance to the screen</source>
        <translation>Abbildung der Strahldichte auf den Bildschirm</translation>
    </message>
    <message>
        <source>Reflectance towards grazing angles; for developers</source>
        <translation>Reflexion bei streifendem Blick; für Entwickler</translation>
    </message>
    <message>
        <source>Direction in which a lobe is looked up; for developers</source>
        <translation>Richtung, in der eine Keule nachgeschlagen wird; für Entwickler</translation>
    </message>
    <message>
        <source>Looks at the form from there</source>
        <translation>Blickt von dort auf die Form</translation>
    </message>
    <message>
        <source>Fill the picture with the form (F)</source>
        <translation>Das Bild mit der Form füllen (F)</translation>
    </message>
    <message>
        <source>The form stands on a ground</source>
        <translation>Die Form steht auf einem Boden</translation>
    </message>
    <message>
        <source>View from</source>
        <translation>Ansicht von</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Parts of the form darken each other where they are close</source>
        <translation>Teile der Form verdunkeln einander, wo sie nahe beieinander sind</translation>
    </message>
    <message>
        <source>Edit Light</source>
        <translation>Licht bearbeiten</translation>
    </message>
    <message>
        <source>Edit this studio or sky in its own panel</source>
        <translation>Dieses Studio oder diesen Himmel in einem eigenen Bedienfeld bearbeiten</translation>
    </message>
    <message>
        <source>{meaning} (Alt + drag)</source>
        <translation>{meaning} (Alt + Ziehen)</translation>
    </message>
    <message>
        <source>High-dynamic-range panorama or studio that lights the surface</source>
        <translation>HDR-Panorama oder Studio, das die Oberfläche beleuchtet</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Projection of the image; choose it where detection fails</source>
        <translation>Projektion des Bildes; wählen, wo die Erkennung versagt</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Visible background; the light does not change</source>
        <translation>Sichtbarer Hintergrund; das Licht ändert sich nicht</translation>
    </message>
    <message>
        <source>Exact, per pixel</source>
        <translation>Genau, je Pixel</translation>
    </message>
    <message>
        <source>Together, by a ball</source>
        <translation>Gemeinsam, über eine Kugel</translation>
    </message>
    <message>
        <source>Each lamp is evaluated in the maps at every pixel: correct for point lamps and grain</source>
        <translation>Jede Lampe wird an jedem Pixel in den Karten ausgewertet: richtig für Punktlampen und Körnung</translation>
    </message>
    <message>
        <source>A ball of the paint is drawn in the light of all lamps, and looked up by the normal: one look-up for any number of lamps, as if they and the viewer were far away</source>
        <translation>Eine Kugel des Lacks wird im Licht aller Lampen gezeichnet und nach der Normalen nachgeschlagen: einmal für beliebig viele Lampen, als wären sie und der Betrachter weit entfernt</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Directional</source>
        <translation>Gerichtet</translation>
    </message>
    <message>
        <source>Lamps</source>
        <translation>Lampen</translation>
    </message>
    <message>
        <source>Add a lamp to the environment</source>
        <translation>Eine Lampe zur Umgebung hinzufügen</translation>
    </message>
    <message>
        <source>Remove this lamp</source>
        <translation>Diese Lampe entfernen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Moves round</source>
        <translation>Kreisen</translation>
    </message>
    <message>
        <source>Rotate the lamps around the surface to see flakes and highlights move</source>
        <translation>Die Lampen um die Oberfläche drehen, um Flakes und Glanzlichter wandern zu sehen</translation>
    </message>
    <message>
        <source>Small lamps in addition to the environment; flakes sparkle in their light</source>
        <translation>Kleine Lampen zusätzlich zur Umgebung; Flakes glitzern in ihrem Licht</translation>
    </message>
    <message>
        <source>From the centre of the scene</source>
        <translation>Von der Mitte der Szene</translation>
    </message>
    <message>
        <source>Factored</source>
        <translation>Faktorisiert</translation>
    </message>
    <message>
        <source>Shading of factored paints by the lamps</source>
        <translation>Schattierung faktorisierter Lacke durch die Lampen</translation>
    </message>
    <message>
        <source>Light booth, average daylight</source>
        <translation>Lichtkabine, mittleres Tageslicht</translation>
    </message>
    <message>
        <source>Light booth, warm daylight (graphic arts)</source>
        <translation>Lichtkabine, warmes Tageslicht (Druckgewerbe)</translation>
    </message>
    <message>
        <source>Light booth, incandescent lamps of 2,856 K</source>
        <translation>Lichtkabine, Glühlampen von 2856 K</translation>
    </message>
    <message>
        <source>Light booth, three-band fluorescent lamps (CIE F11)</source>
        <translation>Lichtkabine, Dreibanden-Leuchtstofflampen (CIE F11)</translation>
    </message>
    <message>
        <source>Light booth, cool white fluorescent lamps (CIE F2)</source>
        <translation>Lichtkabine, kaltweiße Leuchtstofflampen (CIE F2)</translation>
    </message>
    <message>
        <source>Light booth, white LEDs of 4,100 K (CIE LED-B3)</source>
        <translation>Lichtkabine, weiße LEDs von 4100 K (CIE LED-B3)</translation>
    </message>
    <message>
        <source>Sun and sky</source>
        <translation>Sonnenhimmel</translation>
    </message>
    <message>
        <source>Clear sky with the sun</source>
        <translation>Klarer Himmel mit der Sonne</translation>
    </message>
    <message>
        <source>Even, cloudy sky, no sun</source>
        <translation>Gleichmäßig bewölkter Himmel, keine Sonne</translation>
    </message>
    <message>
        <source>Point source</source>
        <translation>Punktlicht</translation>
    </message>
    <message>
        <source>Light booth with one small movable lamp, for sparkle</source>
        <translation>Lichtkabine mit einer kleinen beweglichen Lampe, für Glitzern</translation>
    </message>
    <message>
        <source>Three lamps</source>
        <translation>Drei Lampen</translation>
    </message>
    <message>
        <source>Three movable lamps, no environment – best for factored paints</source>
        <translation>Drei bewegliche Lampen, keine Umgebung – am besten für faktorisierte Lacke</translation>
    </message>
    <message>
        <source>Put the Highlight Here</source>
        <translation>Glanzlicht hierher setzen</translation>
    </message>
    <message>
        <source>Put Another Highlight Here</source>
        <translation>Weiteres Glanzlicht hierher setzen</translation>
    </message>
    <message>
        <source>Remove All Lamps</source>
        <translation>Alle Lampen entfernen</translation>
    </message>
    <message>
        <source>Then click on the surface: the lamp moves to where its reflection is seen there</source>
        <translation>Danach auf die Oberfläche klicken: Die Lampe kommt dorthin, wo ihre Spiegelung an dieser Stelle zu sehen ist</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>From environment</source>
        <translation>Aus der Umgebung</translation>
    </message>
    <message>
        <source>D65, daylight</source>
        <translation>D65, Tageslicht</translation>
    </message>
    <message>
        <source>D50, warm daylight</source>
        <translation>D50, warmes Tageslicht</translation>
    </message>
    <message>
        <source>A, incandescent</source>
        <translation>A, Glühlampe</translation>
    </message>
    <message>
        <source>TL84 (CIE F11)</source>
        <translation>TL84 (CIE F11)</translation>
    </message>
    <message>
        <source>Cool white (CIE F2)</source>
        <translation>Kaltweiß (CIE F2)</translation>
    </message>
    <message>
        <source>LED (CIE LED-B3)</source>
        <translation>LED (CIE LED-B3)</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Chromatic adaptation</source>
        <translation>Chromatische Adaptation</translation>
    </message>
    <message>
        <source>On: white looks white, as to an eye adapted to this light. Off: the tint that a daylight-adapted eye sees</source>
        <translation>Ein: Weiß sieht weiß aus, wie für ein an dieses Licht adaptiertes Auge. Aus: der Farbstich, den ein an Tageslicht adaptiertes Auge sieht</translation>
    </message>
    <message>
        <source>Illuminant</source>
        <translation>Lichtart</translation>
    </message>
    <message>
        <source>Illuminant assumed for the environment&apos;s white</source>
        <translation>Lichtart, die für das Weiß der Umgebung angenommen wird</translation>
    </message>
    <message>
        <source>Exposure mode</source>
        <translation>Belichtungsart</translation>
    </message>
    <message>
        <source>Locked: the exposure is the same in every light. Automatic: the object&apos;s median luminance becomes 18 %, and the exposure value is added</source>
        <translation>Fest: Die Belichtung ist in jedem Licht gleich. Automatisch: Die mittlere Leuchtdichte (Median) des Objekts wird 18 %, und der Belichtungswert kommt hinzu</translation>
    </message>
    <message>
        <source>Colours are being computed from the paint&apos;s spectra.</source>
        <translation>Die Farben werden aus den Spektren des Lacks berechnet.</translation>
    </message>
    <message>
        <source>Colours were computed from the paint&apos;s spectra.</source>
        <translation>Die Farben wurden aus den Spektren des Lacks berechnet.</translation>
    </message>
    <message>
        <source>No metamerism: the paint&apos;s spectrum is unknown. Assuming chromatic adaptation, it is shown as in D65.</source>
        <translation>Keine Metamerie: Das Spektrum des Lacks ist unbekannt. Unter Annahme chromatischer Adaptation wird er wie bei D65 gezeigt.</translation>
    </message>
    <message>
        <source>No metamerism: the paint&apos;s spectrum is unknown. Its colours are tinted by the light (CAT16).</source>
        <translation>Keine Metamerie: Das Spektrum des Lacks ist unbekannt. Seine Farben erhalten den Stich des Lichts (CAT16).</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viewer closed unexpectedly. Recover its view, paint and history of {when}?</source>
        <translation>Viewer wurde unerwartet beendet. Ansicht, Lack und Verlauf von {when} wiederherstellen?</translation>
    </message>
    <message>
        <source>Viewer closed unexpectedly. Recover your unsaved work on the studio “{name}” of {when}?</source>
        <translation>Viewer wurde unerwartet beendet. Ungespeicherte Arbeit am Studio „{name}“ von {when} wiederherstellen?</translation>
    </message>
    <message>
        <source>The current light is an image, which has no lamps to edit.</source>
        <translation>Das jetzige Licht ist ein Bild, das keine Lampen zum Bearbeiten hat.</translation>
    </message>
    <message>
        <source>Create a studio with File ▸ Studio ▸ New, or choose the light booth.</source>
        <translation>Mit Datei ▸ Studio ▸ Neues Studio eines anlegen oder die Lichtkabine wählen.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Change Surroundings</source>
        <translation>Umfeld ändern</translation>
    </message>
    <message>
        <source>Change Sky</source>
        <translation>Himmel ändern</translation>
    </message>
    <message>
        <source>New Studio: {template}</source>
        <translation>Neues Studio: {template}</translation>
    </message>
    <message>
        <source>&amp;Edit Current Light</source>
        <translation>Jetziges Licht &amp;bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Save Studio</source>
        <translation>Studio &amp;speichern</translation>
    </message>
    <message>
        <source>Save Studio &amp;As…</source>
        <translation>Studio speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Not applied: {place}: {reason}</source>
        <translation>Nicht angewandt: {place}: {reason}</translation>
    </message>
    <message>
        <source>Change Lamp</source>
        <translation>Lampe ändern</translation>
    </message>
    <message>
        <source>Move Lamp</source>
        <translation>Lampe verschieben</translation>
    </message>
    <message>
        <source>Scale Lamp</source>
        <translation>Lampengröße ändern</translation>
    </message>
    <message>
        <source>Add Lamp</source>
        <translation>Lampe hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate Lamp</source>
        <translation>Lampe duplizieren</translation>
    </message>
    <message>
        <source>Remove Lamp</source>
        <translation>Lampe entfernen</translation>
    </message>
    <message>
        <source>The picture shows the last valid light.</source>
        <translation>Das Bild zeigt das letzte gültige Licht.</translation>
    </message>
    <message>
        <source>Not saved to a file yet</source>
        <translation>Noch in keiner Datei gespeichert</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>stopped by the time limit</source>
        <translation>vom Zeitlimit beendet</translation>
    </message>
    <message>
        <source>cannot be shown on this screen</source>
        <translation>auf diesem Bildschirm nicht darstellbar</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>White of the picture, D65</source>
        <translation>Weiß des Bildes, D65</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kasten</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Face the centre</source>
        <translation>Zur Mitte gerichtet</translation>
    </message>
    <message>
        <source>Off: the direction is set by the two angles</source>
        <translation>Aus: Die zwei Winkel bestimmen die Richtung</translation>
    </message>
    <message>
        <source>Facing</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>A box is brightest in its middle; strips and rings are even</source>
        <translation>Ein Kasten ist in der Mitte am hellsten; Streifen und Ringe sind gleichmäßig</translation>
    </message>
    <message>
        <source>Position: from the front (+z) towards the right (+x)</source>
        <translation>Lage: von vorn (+z) nach rechts (+x)</translation>
    </message>
    <message>
        <source>Above the horizon at the centre of the scene</source>
        <translation>Über dem Horizont in der Mitte der Szene</translation>
    </message>
    <message>
        <source>Distance from the centre of the scene; the size in metres stays</source>
        <translation>Abstand von der Mitte der Szene; die Größe in Metern bleibt</translation>
    </message>
    <message>
        <source>Angular size, seen face-on from the centre of the scene</source>
        <translation>Winkelgröße, von der Mitte der Szene frontal gesehen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollwinkel</translation>
    </message>
    <message>
        <source>Shines to</source>
        <translation>Leuchtet nach</translation>
    </message>
    <message>
        <source>Azimuth of the direction of emission</source>
        <translation>Azimut der Abstrahlrichtung</translation>
    </message>
    <message>
        <source>and up</source>
        <translation>und hoch</translation>
    </message>
    <message>
        <source>Elevation of the direction of emission</source>
        <translation>Höhenwinkel der Abstrahlrichtung</translation>
    </message>
    <message>
        <source>At its centre</source>
        <translation>In ihrer Mitte</translation>
    </message>
    <message>
        <source>Planckian below 4,000 K, daylight above</source>
        <translation>Unter 4000 K Planckscher Strahler, darüber Tageslicht</translation>
    </message>
    <message>
        <source>Width of the fade at its edge</source>
        <translation>Breite des Verlaufs am Rand</translation>
    </message>
    <message>
        <source>{side}: {metres}; the angle is its face-on angular size</source>
        <translation>{side}: {metres}; der Winkel ist die Größe bei frontalem Blick</translation>
    </message>
    <message>
        <source>Name of the studio</source>
        <translation>Name des Studios</translation>
    </message>
    <message>
        <source>Lamps of the studio</source>
        <translation>Lampen des Studios</translation>
    </message>
    <message>
        <source>Save the studio (Ctrl+S in this panel)</source>
        <translation>Das Studio speichern (Strg+S in diesem Bedienfeld)</translation>
    </message>
    <message>
        <source>Save the studio under another name</source>
        <translation>Das Studio unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z in this panel)</source>
        <translation>Rückgängig (Strg+Z in diesem Bedienfeld)</translation>
    </message>
    <message>
        <source>Add a lamp</source>
        <translation>Eine Lampe hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate this lamp</source>
        <translation>Diese Lampe duplizieren</translation>
    </message>
    <message>
        <source>Light the picture with this studio</source>
        <translation>Das Bild mit diesem Studio beleuchten</translation>
    </message>
    <message>
        <source>No studio is open. Create one, or edit the current light.</source>
        <translation>Kein Studio ist offen. Eines anlegen oder das jetzige Licht bearbeiten.</translation>
    </message>
    <message>
        <source>Edit current light</source>
        <translation>Jetziges Licht bearbeiten</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>neutral</translation>
    </message>
    <message>
        <source>{azimuth:.0f}° and {elevation:.0f}° up</source>
        <translation>{azimuth:.0f}° und {elevation:.0f}° hoch</translation>
    </message>
    <message>
        <source>Panorama of the studio</source>
        <translation>Panorama des Studios</translation>
    </message>
    <message>
        <source>Full panorama, front at the centre. Click a lamp to select it, drag it to move it, turn the wheel over it to resize it, arrow keys move it by 1°</source>
        <translation>Ganzes Panorama, vorn in der Mitte. Klick auf eine Lampe wählt sie, Ziehen verschiebt sie, das Mausrad darüber ändert ihre Größe, Pfeiltasten verschieben sie um 1°</translation>
    </message>
    <message>
        <source>Plain backdrop</source>
        <translation>Einfarbiger Hintergrund</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativ</translation>
    </message>
    <message>
        <source>Clear (Hošek-Wilkie)</source>
        <translation>Klar (Hošek-Wilkie)</translation>
    </message>
    <message>
        <source>Clear (Preetham)</source>
        <translation>Klar (Preetham)</translation>
    </message>
    <message>
        <source>Overcast (CIE)</source>
        <translation>Bedeckt (CIE)</translation>
    </message>
    <message>
        <source>Eye height</source>
        <translation>Augenhöhe</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of luminances; the exposure is set for a white card</source>
        <translation>Einheit der Leuchtdichten; die Belichtung ist auf eine weiße Karte eingestellt</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Umfeld</translation>
    </message>
    <message>
        <source>Visible where there is no lamp</source>
        <translation>Sichtbar, wo keine Lampe ist</translation>
    </message>
    <message>
        <source>Uniform; 0 is black</source>
        <translation>Gleichmäßig; 0 ist schwarz</translation>
    </message>
    <message>
        <source>Colour of the backdrop</source>
        <translation>Farbe des Hintergrunds</translation>
    </message>
    <message>
        <source>Sun in the picture</source>
        <translation>Sonne im Bild</translation>
    </message>
    <message>
        <source>The solar disc, 0.53° in diameter</source>
        <translation>Die Sonnenscheibe, 0,53° im Durchmesser</translation>
    </message>
    <message>
        <source>Published sky model</source>
        <translation>Veröffentlichtes Himmelsmodell</translation>
    </message>
    <message>
        <source>Turbidity</source>
        <translation>Trübung</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Box, strip and ring</source>
        <translation>Kasten, Streifen und Ring</translation>
    </message>
    <message>
        <source>Light tunnel</source>
        <translation>Lichttunnel</translation>
    </message>
    <message>
        <source>My booth</source>
        <translation>Meine Lichtkabine</translation>
    </message>
    <message>
        <source>One box above</source>
        <translation>Ein Kasten oben</translation>
    </message>
    <message>
        <source>My studio</source>
        <translation>Mein Studio</translation>
    </message>
    <message>
        <source>Sky with sun</source>
        <translation>Himmel mit Sonne</translation>
    </message>
    <message>
        <source>My sky</source>
        <translation>Mein Himmel</translation>
    </message>
    <message>
        <source>no sparkle</source>
        <translation>kein Glitzern</translation>
    </message>
    <message>
        <source>flake texture</source>
        <translation>Flake-Textur</translation>
    </message>
    <message>
        <source>glints</source>
        <translation>Glitzerpunkte</translation>
    </message>
    <message>
        <source>no Fresnel</source>
        <translation>kein Fresnel</translation>
    </message>
    <message>
        <source>Fresnel raised</source>
        <translation>Fresnel angehoben</translation>
    </message>
    <message>
        <source>Fresnel by angle</source>
        <translation>Fresnel nach Winkel</translation>
    </message>
    <message>
        <source>Frame {ms} ms</source>
        <translation>Bild {ms} ms</translation>
    </message>
    <message>
        <source>{sparkle}, {count} lights</source>
        <translation>{sparkle}, {count} Lichter</translation>
    </message>
    <message>
        <source>Frame time: median of the last {count}; slowest {slowest:.1f} ms</source>
        <translation>Bildzeit: Median der letzten {count}; längste {slowest:.1f} ms</translation>
    </message>
    <message>
        <source>{words}  view {view:.0f}°</source>
        <translation>{words}  Blick {view:.0f}°</translation>
    </message>
    <message>
        <source>{words}  view {view:.0f}°  aspecular {aspecular:.0f}°</source>
        <translation>{words}  Blick {view:.0f}°  aspekular {aspecular:.0f}°</translation>
    </message>
    <message>
        <source>radiance</source>
        <translation>Strahldichte</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>view {view:.1f}°</source>
        <translation>Blick {view:.1f}°</translation>
    </message>
    <message>
        <source>view {view:.1f}°   aspecular {aspecular:.1f}°</source>
        <translation>Blick {view:.1f}°   aspekular {aspecular:.1f}°</translation>
    </message>
    <message>
        <source>no aspecular angle: no dominant light source</source>
        <translation>kein Aspekularwinkel: keine vorherrschende Lichtquelle</translation>
    </message>
    <message>
        <source>facing away from {light}</source>
        <translation>abgewandt von {light}</translation>
    </message>
    <message>
        <source>from {light}</source>
        <translation>von {light}</translation>
    </message>
    <message>
        <source>x {x:.1f}  y {y:.1f}  z {z:.1f} mm on {part} ({material})</source>
        <translation>x {x:.1f}  y {y:.1f}  z {z:.1f} mm auf {part} ({material})</translation>
    </message>
    <message>
        <source>The pixel under the cursor. L*a*b*: exposed light before the tone curve, D65 and 10°, a white of radiance 1 has L* 100. View: angle to the surface&apos;s normal. Aspecular: angle from the mirror direction of {light}.</source>
        <translation>Das Pixel unter dem Zeiger. L*a*b*: belichtetes Licht vor der Tonwertkurve, D65 und 10°, ein Weiß der Strahldichte 1 hat L* 100. Blick: Winkel zur Normalen der Oberfläche. Aspekular: Winkel von der Spiegelrichtung zu {light}.</translation>
    </message>
    <message>
        <source>no dominant light source</source>
        <translation>keine vorherrschende Lichtquelle</translation>
    </message>
    <message>
        <source>The picture shows {shown}. Choose another paint, or correct this one.</source>
        <translation>Das Bild zeigt {shown}. Einen anderen Lack wählen oder diesen berichtigen.</translation>
    </message>
    <message>
        <source>{link} (not following)</source>
        <translation>{link} (folgt nicht)</translation>
    </message>
    <message>
        <source>No measured angles to compare with</source>
        <translation>Keine gemessenen Winkel zum Vergleichen</translation>
    </message>
    <message>
        <source>Fit ΔE00 {worst}</source>
        <translation>Anpassung ΔE00 {worst}</translation>
    </message>
    <message>
        <source>Maximum ΔE00 of the fit at the measured angles</source>
        <translation>Größtes ΔE00 der Anpassung an den gemessenen Winkeln</translation>
    </message>
    <message>
        <source>{count} cosine lobes, fitted in {ms} ms</source>
        <translation>{count} Kosinuskeulen, angepasst in {ms} ms</translation>
    </message>
    <message>
        <source>Open palette; the arrow keys select its paints</source>
        <translation>Offene Palette; die Pfeiltasten wählen ihre Lacke</translation>
    </message>
    <message>
        <source>{name} (closed)</source>
        <translation>{name} (geschlossen)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Designer is open. Follow it to see its paint at every change.</source>
        <translation>Designer ist offen. Ihm folgen, um den Lack bei jeder Änderung zu sehen.</translation>
    </message>
    <message>
        <source>Until then Viewer shows the paint that it was started with.</source>
        <translation>Bis dahin zeigt Viewer den Lack, mit dem er gestartet wurde.</translation>
    </message>
    <message>
        <source>Follow Designer</source>
        <translation>Designer folgen</translation>
    </message>
    <message>
        <source>Factored paint: lamps use its maps, the environment uses fitted lobes.</source>
        <translation>Faktorisierter Lack: Lampen verwenden seine Karten, die Umgebung angepasste Keulen.</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>Angehoben</translation>
    </message>
    <message>
        <source>Several angles</source>
        <translation>Mehrere Winkel</translation>
    </message>
    <message>
        <source>The lobes fitted at 45°, with the coat brightened and the base dimmed by the exact Fresnel equations</source>
        <translation>Die bei 45° angepassten Keulen, durch die genauen Fresnel-Gleichungen der Klarlack aufgehellt und die Basis gedämpft</translation>
    </message>
    <message>
        <source>Lobes fitted at 16 angles of incidence and interpolated, also in their shape; measured files, which have no separate coat, are raised</source>
        <translation>An 16 Einfallswinkeln angepasste Keulen, auch in der Form interpoliert; Messdateien ohne getrennten Klarlack werden angehoben</translation>
    </message>
    <message>
        <source>The lobes of 45° at every angle</source>
        <translation>Die Keulen von 45° an jedem Winkel</translation>
    </message>
    <message>
        <source>Shifted (exact horizon)</source>
        <translation>Verschoben (genauer Horizont)</translation>
    </message>
    <message>
        <source>Mirror direction (paper)</source>
        <translation>Spiegelrichtung (Veröffentlichung)</translation>
    </message>
    <message>
        <source>Each lobe is looked up between mirror direction and normal: only light above the surface counts</source>
        <translation>Jede Keule wird zwischen Spiegelrichtung und Normale nachgeschlagen: Nur Licht über der Oberfläche zählt</translation>
    </message>
    <message>
        <source>Each lobe is looked up in the mirror direction and dimmed by its cosine, as published by Westlund and Meyer: broad lobes take light from below the surface, towards grazing angles</source>
        <translation>Jede Keule wird in der Spiegelrichtung nachgeschlagen und mit ihrem Kosinus gedämpft, wie von Westlund und Meyer veröffentlicht: Breite Keulen nehmen bei streifenden Winkeln Licht von unterhalb der Oberfläche auf</translation>
    </message>
    <message>
        <source>Fresnel</source>
        <translation>Fresnel</translation>
    </message>
    <message>
        <source>Coat and base</source>
        <translation>Klarlack, Basis</translation>
    </message>
    <message>
        <source>Dependence on the viewing angle</source>
        <translation>Abhängigkeit vom Blickwinkel</translation>
    </message>
    <message>
        <source>Look-up</source>
        <translation>Nachschlagen</translation>
    </message>
    <message>
        <source>Direction in which a lobe is looked up in the filtered light</source>
        <translation>Richtung, in der eine Keule im gefilterten Licht nachgeschlagen wird</translation>
    </message>
    <message>
        <source>Colours at the measured angles</source>
        <translation>Farben an den gemessenen Winkeln</translation>
    </message>
    <message>
        <source>Outside this screen&apos;s colours: shown clipped</source>
        <translation>Außerhalb der Farben dieses Bildschirms: beschnitten gezeigt</translation>
    </message>
    <message>
        <source>Light {light:g}°, aspecular {aspecular:g}°</source>
        <translation>Licht {light:g}°, aspekular {aspecular:g}°</translation>
    </message>
    <message>
        <source>Show the paint that is being edited in Designer, at every change</source>
        <translation>Den Lack, der in Designer bearbeitet wird, bei jeder Änderung zeigen</translation>
    </message>
    <message>
        <source>Open a paint (.brdfpaint) or a measured file</source>
        <translation>Einen Lack (.brdfpaint) oder eine Messdatei öffnen</translation>
    </message>
    <message>
        <source>Choosing another paint stops following Designer</source>
        <translation>Ein anderer Lack beendet das Folgen</translation>
    </message>
    <message>
        <source>Fit: no measured angles to compare with{limited}</source>
        <translation>Anpassung: keine gemessenen Winkel zum Vergleichen{limited}</translation>
    </message>
    <message>
        <source>Fit: maximum ΔE00 {worst:.2f} at the measured angles{limited}</source>
        <translation>Anpassung: größtes ΔE00 {worst:.2f} an den gemessenen Winkeln{limited}</translation>
    </message>
    <message>
        <source>Follow Designer (not open)</source>
        <translation>Designer folgen (nicht offen)</translation>
    </message>
    <message>
        <source>{name}, {number} of {count}</source>
        <translation>{name}, {number} von {count}</translation>
    </message>
    <message>
        <source>Glints, at any distance</source>
        <translation>Glitzerpunkte, in jedem Abstand</translation>
    </message>
    <message>
        <source>Flake texture, near only</source>
        <translation>Flake-Textur, nur nah</translation>
    </message>
    <message>
        <source>Off, mean of all flakes</source>
        <translation>Aus, Mittel aller Flakes</translation>
    </message>
    <message>
        <source>Individual flakes sparkle in the brightest lights and blend into the mean with distance</source>
        <translation>Einzelne Flakes glitzern in den hellsten Lichtern und gehen mit dem Abstand in das Mittel über</translation>
    </message>
    <message>
        <source>One flake per texture cell (Günther et al. 2005); fades with distance</source>
        <translation>Ein Flake je Texturzelle (Günther et al. 2005); verblasst mit dem Abstand</translation>
    </message>
    <message>
        <source>No individual flakes, only their mean</source>
        <translation>Keine einzelnen Flakes, nur ihr Mittel</translation>
    </message>
    <message>
        <source>This paint has no flake data; no flakes are drawn.</source>
        <translation>Dieser Lack hat keine Angaben zu Flakes; keine werden gezeichnet.</translation>
    </message>
    <message>
        <source>Sparkle</source>
        <translation>Glitzern</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>Drawing of individual flakes</source>
        <translation>Zeichnung einzelner Flakes</translation>
    </message>
    <message>
        <source>colours spread by {spread:.2g}</source>
        <translation>Farben um {spread:.2g} gestreut</translation>
    </message>
    <message>
        <source>{density:,.4g} flakes per mm² of {size:.4g} µm, tilts spread by {roughness:.2g}, {colour}</source>
        <translation>{density:,.4g} Flakes je mm² von {size:.4g} µm, Neigungen um {roughness:.2g} gestreut, {colour}</translation>
    </message>
    <message>
        <source>of one colour</source>
        <translation>einfarbig</translation>
    </message>
    <message>
        <source>Sunny sky</source>
        <translation>Sonniger Himmel</translation>
    </message>
    <message>
        <source>Overcast sky</source>
        <translation>Bedeckter Himmel</translation>
    </message>
    <message>
        <source>Curved panel</source>
        <translation>Gewölbtes Blech</translation>
    </message>
    <message>
        <source>Car</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The picture shows {shown}. Choose another one in the inspector, or drop a file on the picture.</source>
        <translation>Das Bild zeigt {shown}. Im Inspektor etwas anderes wählen oder eine Datei auf das Bild ziehen.</translation>
    </message>
    <message>
        <source>Viewer opens files that end in {endings}.</source>
        <translation>Viewer öffnet Dateien, die auf {endings} enden.</translation>
    </message>
    <message>
        <source>Drop one of these.</source>
        <translation>Eine solche Datei hierher ziehen.</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Wird geladen</translation>
    </message>
    <message>
        <source>{title}, draft</source>
        <translation>{title}, Entwurf</translation>
    </message>
    <message>
        <source>Full quality follows after editing</source>
        <translation>Volle Güte folgt nach der Bearbeitung</translation>
    </message>
    <message>
        <source>Refining reflections</source>
        <translation>Spiegelungen werden verfeinert</translation>
    </message>
    <message>
        <source>Stopped; select the light again to finish</source>
        <translation>Angehalten; das Licht erneut wählen, um sie fertigzustellen</translation>
    </message>
    <message>
        <source>{title}, maps {made} of {wanted}</source>
        <translation>{title}, Karten {made} von {wanted}</translation>
    </message>
    <message>
        <source>{triangles:,} triangles, 1 part</source>
        <translation>{triangles:,} Dreiecke, 1 Teil</translation>
    </message>
    <message>
        <source>{triangles:,} triangles, {parts} parts</source>
        <translation>{triangles:,} Dreiecke, {parts} Teile</translation>
    </message>
    <message>
        <source>The surface is shown without ambient occlusion.</source>
        <translation>Die Oberfläche wird ohne Umgebungsverdeckung gezeigt.</translation>
    </message>
    <message>
        <source>Computing ambient occlusion…</source>
        <translation>Umgebungsverdeckung wird berechnet …</translation>
    </message>
    <message>
        <source>Shown without ambient occlusion; it has not been computed.</source>
        <translation>Ohne Umgebungsverdeckung gezeigt; sie wurde nicht berechnet.</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Clear lens</source>
        <translation>Klare Streuscheibe</translation>
    </message>
    <message>
        <source>Rubber</source>
        <translation>Gummi</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>Chrom</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Tail lamp</source>
        <translation>Rücklicht</translation>
    </message>
    <message>
        <source>Trim, matt black</source>
        <translation>Zierteil, mattschwarz</translation>
    </message>
    <message>
        <source>Dark cavity</source>
        <translation>Dunkler Hohlraum</translation>
    </message>
    <message>
        <source>Gap between panels</source>
        <translation>Fuge zwischen Blechen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Click a part in the picture to select it; Ctrl and Shift select several in the list</source>
        <translation>Klick auf einen Teil im Bild wählt ihn; Strg und Umschalt wählen mehrere in der Liste</translation>
    </message>
    <message>
        <source>Material of selected parts</source>
        <translation>Material gewählter Teile</translation>
    </message>
    <message>
        <source>Material of the parts selected above</source>
        <translation>Material der oben gewählten Teile</translation>
    </message>
    <message>
        <source>From file</source>
        <translation>Aus der Datei</translation>
    </message>
    <message>
        <source>No second paint</source>
        <translation>Kein zweiter Lack</translation>
    </message>
    <message>
        <source>The picture is unchanged. Open another file in the inspector.</source>
        <translation>Das Bild ist unverändert. Im Inspektor eine andere Datei öffnen.</translation>
    </message>
    <message>
        <source>Tiled</source>
        <translation>Gekachelt</translation>
    </message>
    <message>
        <source>Projected from the side</source>
        <translation>Von der Seite projiziert</translation>
    </message>
    <message>
        <source>Projected from the front</source>
        <translation>Von vorn projiziert</translation>
    </message>
    <message>
        <source>Projected from above</source>
        <translation>Von oben projiziert</translation>
    </message>
    <message>
        <source>Relief and two-tone</source>
        <translation>Relief und Zweifarbigkeit</translation>
    </message>
    <message>
        <source>Open a normal map</source>
        <translation>Eine Normal-Map öffnen</translation>
    </message>
    <message>
        <source>Remove the normal map</source>
        <translation>Die Normal-Map entfernen</translation>
    </message>
    <message>
        <source>Open a tangent map</source>
        <translation>Eine Tangenten-Map öffnen</translation>
    </message>
    <message>
        <source>Remove the tangent map</source>
        <translation>Die Tangenten-Map entfernen</translation>
    </message>
    <message>
        <source>Open a second paint</source>
        <translation>Einen zweiten Lack öffnen</translation>
    </message>
    <message>
        <source>Open a mask</source>
        <translation>Eine Maske öffnen</translation>
    </message>
    <message>
        <source>Remove the mask</source>
        <translation>Die Maske entfernen</translation>
    </message>
    <message>
        <source>Mask width</source>
        <translation>Maskenbreite</translation>
    </message>
    <message>
        <source>Normal map</source>
        <translation>Normal-Map</translation>
    </message>
    <message>
        <source>An image of normals (PNG, EXR …), tiled over the paint</source>
        <translation>Ein Bild der Normalen (PNG, EXR …), über den Lack gekachelt</translation>
    </message>
    <message>
        <source>Tangent map</source>
        <translation>Tangenten-Map</translation>
    </message>
    <message>
        <source>An image of the grain&apos;s direction in anisotropic factored paints</source>
        <translation>Ein Bild der Richtung der Maserung in anisotropen faktorisierten Lacken</translation>
    </message>
    <message>
        <source>Tile width</source>
        <translation>Kachelbreite</translation>
    </message>
    <message>
        <source>Second paint</source>
        <translation>Zweiter Lack</translation>
    </message>
    <message>
        <source>Shown where the mask is white</source>
        <translation>Gezeigt, wo die Maske weiß ist</translation>
    </message>
    <message>
        <source>An image: black is the first paint, white the second</source>
        <translation>Ein Bild: Schwarz ist der erste Lack, Weiß der zweite</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Mapping of the mask onto the surface</source>
        <translation>Abbildung der Maske auf die Oberfläche</translation>
    </message>
    <message>
        <source>Waves of {height:.2g} µm (RMS height)</source>
        <translation>Wellen von {height:.2g} µm (quadr. Mittel der Höhe)</translation>
    </message>
    <message>
        <source>{waves}, instead of the paint&apos;s own</source>
        <translation>{waves}, statt der eigenen des Lacks</translation>
    </message>
    <message>
        <source>The paint&apos;s own: {height:g} µm (RMS height), {length:g} mm. A slope set here replaces it.</source>
        <translation>Eigene des Lacks: {height:g} µm (quadr. Mittel der Höhe), {length:g} mm. Eine hier gesetzte Neigung ersetzt sie.</translation>
    </message>
    <message>
        <source>Open a mask to see the second paint.</source>
        <translation>Eine Maske öffnen, um den zweiten Lack zu sehen.</translation>
    </message>
    <message>
        <source>Choose a second paint to see the mask.</source>
        <translation>Einen zweiten Lack wählen, um die Maske zu sehen.</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y oben</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z oben</translation>
    </message>
    <message>
        <source>Smooth, edges above 40°</source>
        <translation>Glatt, Kanten ab 40°</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Darkens recesses; computed once per surface in the background</source>
        <translation>Verdunkelt Vertiefungen; einmal je Oberfläche im Hintergrund berechnet</translation>
    </message>
    <message>
        <source>Ground with contact shadow</source>
        <translation>Boden mit Kontaktschatten</translation>
    </message>
    <message>
        <source>Ground at the lowest point of the surface, with its shadow in the environment&apos;s light</source>
        <translation>Boden am tiefsten Punkt der Oberfläche, mit ihrem Schatten im Licht der Umgebung</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Restart the cancelled computation</source>
        <translation>Die abgebrochene Berechnung neu starten</translation>
    </message>
    <message>
        <source>Centre on ground</source>
        <translation>Auf den Boden stellen</translation>
    </message>
    <message>
        <source>Flip normals</source>
        <translation>Normalen umkehren</translation>
    </message>
    <message>
        <source>Surface to which the paint is applied</source>
        <translation>Oberfläche, auf die der Lack aufgetragen ist</translation>
    </message>
    <message>
        <source>Unit of length in the file</source>
        <translation>Längeneinheit in der Datei</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Axis that points up in the file</source>
        <translation>Achse, die in der Datei nach oben zeigt</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Feinheit</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Moves the centre over the origin and the lowest point to height 0</source>
        <translation>Setzt die Mitte über den Ursprung und den tiefsten Punkt auf Höhe 0</translation>
    </message>
    <message>
        <source>Open a mesh (glTF, FBX, USD, STEP, OBJ, STL, PLY and others)</source>
        <translation>Netz öffnen (glTF, FBX, USD, STEP, OBJ, STL, PLY und andere)</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Read from the file, or recomputed</source>
        <translation>Aus der Datei gelesen oder neu berechnet</translation>
    </message>
    <message>
        <source>For files whose triangles and normals point inwards</source>
        <translation>Für Dateien, deren Dreiecke und Normalen nach innen zeigen</translation>
    </message>
    <message>
        <source>sRGB; {profile} is not used</source>
        <translation>sRGB; {profile} wird nicht verwendet</translation>
    </message>
    <message>
        <source>Faithful, soft highlights</source>
        <translation>Getreu, weiche Glanzlichter</translation>
    </message>
    <message>
        <source>Neutral (Khronos PBR)</source>
        <translation>Neutral (Khronos PBR)</translation>
    </message>
    <message>
        <source>Characteristic curve</source>
        <translation>Filmkennlinie</translation>
    </message>
    <message>
        <source>ACES (fitted)</source>
        <translation>ACES (angepasst)</translation>
    </message>
    <message>
        <source>Linear, clipping marked</source>
        <translation>Linear, Übersteuerung markiert</translation>
    </message>
    <message>
        <source>Shows colours unchanged; compresses only values above 0.8</source>
        <translation>Zeigt Farben unverändert; staucht nur Werte über 0,8</translation>
    </message>
    <message>
        <source>Removes 4 % of reflection from dark tones, keeps hue and saturation, compresses highlights</source>
        <translation>Nimmt dunklen Tönen 4 % Reflexion, hält Buntton und Sättigung, staucht Glanzlichter</translation>
    </message>
    <message>
        <source>A film&apos;s S-shaped response in log exposure</source>
        <translation>Die S-förmige Antwort eines Films in log. Belichtung</translation>
    </message>
    <message>
        <source>The film industry&apos;s rendering, as Hill fitted it: darker and with more contrast; 0.18 becomes 0.11</source>
        <translation>Die Wiedergabe der Filmindustrie, wie Hill sie angepasst hat: dunkler und kontrastreicher; aus 0,18 wird 0,11</translation>
    </message>
    <message>
        <source>Sixteen stops in a soft curve; bright saturated light desaturates to white, as on film</source>
        <translation>Sechzehn Blenden in einer weichen Kurve; helles gesättigtes Licht entsättigt zu Weiß, wie auf Film</translation>
    </message>
    <message>
        <source>No curve, for judging colours; highlights are clipped and marked</source>
        <translation>Keine Kurve, zum Beurteilen von Farben; Glanzlichter werden beschnitten und markiert</translation>
    </message>
    <message>
        <source>Stripes</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Tone</source>
        <translation>Tonwerte</translation>
    </message>
    <message>
        <source>Mark clipped highlights: black stripes, or orange</source>
        <translation>Übersteuerte Glanzlichter markieren: schwarze Streifen oder Orange</translation>
    </message>
    <message>
        <source>Out of gamut</source>
        <translation>Außerhalb des Farbraums</translation>
    </message>
    <message>
        <source>Mark colours outside the screen&apos;s gamut: grey stripes in the other direction, or blue</source>
        <translation>Farben außerhalb des Farbraums des Bildschirms markieren: graue Streifen in der anderen Richtung oder Blau</translation>
    </message>
    <message>
        <source>Monitor profile</source>
        <translation>Monitorprofil</translation>
    </message>
    <message>
        <source>Convert colours with the system&apos;s profile of this monitor</source>
        <translation>Farben mit dem Profil umrechnen, das das System für diesen Monitor hat</translation>
    </message>
    <message>
        <source>Glare</source>
        <translation>Blendung</translation>
    </message>
    <message>
        <source>Spread light above white as the eye scatters it; readings, marks and linear files are without</source>
        <translation>Licht über Weiß so streuen, wie das Auge es streut; Messwerte, Markierungen und lineare Dateien bleiben ohne</translation>
    </message>
    <message>
        <source>Tone curve</source>
        <translation>Tonwertkurve</translation>
    </message>
    <message>
        <source>Mapping of radiance to the screen, before its transfer curve</source>
        <translation>Abbildung der Strahldichte auf den Bildschirm, vor dessen Übertragungskurve</translation>
    </message>
    <message>
        <source>Show clipping</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Style of the marks; stripes keep the colour between them visible</source>
        <translation>Stil der Marken; Streifen lassen die Farbe dazwischen sichtbar</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Bildschirm</translation>
    </message>
    <message>
        <source>The object is outside the picture</source>
        <translation>Das Objekt ist außerhalb des Bildes</translation>
    </message>
    <message>
        <source>Clipped highlights: none; out of gamut: {gamut}</source>
        <translation>Übersteuerte Glanzlichter: keine; außerhalb des Farbraums: {gamut}</translation>
    </message>
    <message>
        <source>Clipped highlights: {bright} of the object; out of gamut: {gamut}</source>
        <translation>Übersteuerte Glanzlichter: {bright} des Objekts; außerhalb des Farbraums: {gamut}</translation>
    </message>
    <message>
        <source>less than 0.1 %</source>
        <translation>weniger als 0,1 %</translation>
    </message>
    <message>
        <source>EXR, radiance with variance</source>
        <translation>EXR, Strahldichte mit Varianz</translation>
    </message>
    <message>
        <source>The real-time picture continues.</source>
        <translation>Das Echtzeitbild läuft weiter.</translation>
    </message>
    <message>
        <source>Try Again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Saved {name}</source>
        <translation>{name} gespeichert</translation>
    </message>
    <message>
        <source>Real-time picture; {renderer}: stopped</source>
        <translation>Echtzeitbild; {renderer}: angehalten</translation>
    </message>
    <message>
        <source>waiting for changes to end</source>
        <translation>wartet auf das Ende der Änderungen</translation>
    </message>
    <message>
        <source>starting…</source>
        <translation>startet …</translation>
    </message>
    <message>
        <source>Real-time picture; {renderer}: {step}</source>
        <translation>Echtzeitbild; {renderer}: {step}</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>The picture could not be read: {reason}</source>
        <translation>Das Bild konnte nicht gelesen werden: {reason}</translation>
    </message>
    <message>
        <source>The renderer could not be started: {reason}.</source>
        <translation>Der Renderer konnte nicht gestartet werden: {reason}.</translation>
    </message>
    <message>
        <source>no message; the computer may be out of memory</source>
        <translation>keine Meldung; vielleicht fehlt dem Rechner Speicher</translation>
    </message>
    <message>
        <source>The renderer crashed (signal {code}): {words}.</source>
        <translation>Der Renderer stürzte ab (Signal {code}): {words}.</translation>
    </message>
    <message>
        <source>The renderer ended (status {code}): {words}.</source>
        <translation>Der Renderer endete (Status {code}): {words}.</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>Renderer</translation>
    </message>
    <message>
        <source>Denoise</source>
        <translation>Entrauschen</translation>
    </message>
    <message>
        <source>Stop refining and free the processors</source>
        <translation>Das Verfeinern anhalten und die Prozessoren freigeben</translation>
    </message>
    <message>
        <source>Refine the picture further</source>
        <translation>Das Bild weiter verfeinern</translation>
    </message>
    <message>
        <source>Renderer of the picture</source>
        <translation>Renderer des Bildes</translation>
    </message>
    <message>
        <source>Lights, reflections and samples of the ray tracer: 16, 1, 1; 128, 16, 16; 1024, 256, 64</source>
        <translation>Lichter, Spiegelungen und Abtastwerte des Strahlverfolgers: 16, 1, 1; 128, 16, 16; 1024, 256, 64</translation>
    </message>
    <message>
        <source>Samples per pixel at which the path tracer stops; 0: unlimited</source>
        <translation>Abtastwerte je Pixel, bei denen der Pfadverfolger anhält; 0: unbegrenzt</translation>
    </message>
    <message>
        <source>The renderer has not been started yet.</source>
        <translation>Der Renderer wurde noch nicht gestartet.</translation>
    </message>
    <message>
        <source>A denoiser estimates detail hidden by noise: for viewing, not for measuring</source>
        <translation>Ein Entrauscher schätzt Einzelheiten, die das Rauschen verdeckt: zum Ansehen, nicht zum Messen</translation>
    </message>
    <message>
        <source>Real-time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Ray-traced</source>
        <translation>Strahlverfolgt</translation>
    </message>
    <message>
        <source>Path-traced</source>
        <translation>Pfadverfolgt</translation>
    </message>
    <message>
        <source>Fitted lobes in prefiltered light</source>
        <translation>Angepasste Keulen in vorgefiltertem Licht</translation>
    </message>
    <message>
        <source>The paint itself under many lights, with shadows and self-reflections</source>
        <translation>Der Lack selbst unter vielen Lichtern, mit Schatten und Selbstspiegelungen</translation>
    </message>
    <message>
        <source>The paint itself, path-traced, as ground truth; refines while nothing changes</source>
        <translation>Der Lack selbst, pfadverfolgt, als Bezugswert; verfeinert sich, solange nichts geändert wird</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>The ground shadow is that of the real-time picture.</source>
        <translation>Der Bodenschatten ist der des Echtzeitbildes.</translation>
    </message>
    <message>
        <source>The denoiser (OptiX) needs an NVIDIA graphics card, which is not used here.</source>
        <translation>Der Entrauscher (OptiX) braucht eine NVIDIA-Grafikkarte, die hier nicht verwendet wird.</translation>
    </message>
    <message>
        <source>The ray tracer uses the same lights in each pixel: there is no noise to remove.</source>
        <translation>Der Strahlverfolger verwendet in jedem Pixel dieselben Lichter: Es gibt kein Rauschen zu entfernen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size; make the window smaller.</source>
        <translation>Für ein Bild dieser Größe fehlt Speicher; das Fenster verkleinern.</translation>
    </message>
    <message>
        <source>Ray-traced, {quality}</source>
        <translation>Strahlverfolgt, {quality}</translation>
    </message>
    <message>
        <source>{count} of {all} samples</source>
        <translation>{count} von {all} Abtastwerten</translation>
    </message>
    <message>
        <source>{count} samples</source>
        <translation>{count} Abtastwerte</translation>
    </message>
    <message>
        <source>noise {percent} %</source>
        <translation>Rauschen {percent} %</translation>
    </message>
    <message>
        <source>denoised</source>
        <translation>entrauscht</translation>
    </message>
    <message>
        <source>{seconds} s a frame</source>
        <translation>{seconds} s je Bild</translation>
    </message>
    <message>
        <source>{rate} frames/s</source>
        <translation>{rate} Bilder/s</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bildzeit</translation>
    </message>
    <message>
        <source>Which paint, its flakes, orange peel and second colour</source>
        <translation>Welcher Lack, seine Flakes, Orangenhaut und zweite Farbe</translation>
    </message>
    <message>
        <source>The light that the paint stands in, and what is behind it</source>
        <translation>Das Licht, in dem der Lack steht, und der Hintergrund</translation>
    </message>
    <message>
        <source>A second paint or picture beside the first</source>
        <translation>Ein zweiter Lack oder ein Bild neben dem ersten</translation>
    </message>
    <message>
        <source>The renderer, and files of what is seen</source>
        <translation>Das Renderverfahren, und Dateien dessen, was zu sehen ist</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>readout</source>
        <translation>Messwerte am Zeiger</translation>
    </message>
    <message>
        <source>The work could not be started: {reason}.</source>
        <translation>Die Berechnung konnte nicht gestartet werden: {reason}.</translation>
    </message>
    <message>
        <source>The work ended without a message.</source>
        <translation>Die Berechnung endete ohne Meldung.</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Looking for flakes…</source>
        <translation>Flakes werden gesucht …</translation>
    </message>
    <message>
        <source>The paint has changed; look again.</source>
        <translation>Der Lack hat sich geändert; bitte erneut suchen.</translation>
    </message>
    <message>
        <source>Find Flakes</source>
        <translation>Flakes suchen</translation>
    </message>
    <message>
        <source>Flakes found. Undo brings the others back.</source>
        <translation>Flakes gefunden. Rückgängig bringt die anderen zurück.</translation>
    </message>
    <message>
        <source>graininess</source>
        <translation>Körnigkeit</translation>
    </message>
    <message>
        <source>{name}: nearest {value:.3g} %, {away:+.0f} %</source>
        <translation>{name}: am nächsten {value:.3g} %, {away:+.0f} %</translation>
    </message>
    <message>
        <source>Not reachable with flakes in a paint of this colour. The nearest are set.</source>
        <translation>Mit Flakes in einem Lack dieser Farbe nicht erreichbar. Die nächstliegenden sind gesetzt.</translation>
    </message>
    <message>
        <source>Sketch of the rig from above: a painted sphere in the middle, a fixed camera, and a lamp that moves around the sphere from 0° at the camera to 180°</source>
        <translation>Skizze des Messaufbaus von oben: eine lackierte Kugel in der Mitte, eine feste Kamera und eine Lampe, die sich von 0° bei der Kamera bis 180° um die Kugel bewegt</translation>
    </message>
    <message>
        <source>Lamp, moved in steps</source>
        <translation>Lampe, schrittweise bewegt</translation>
    </message>
    <message>
        <source>Camera, fixed</source>
        <translation>Kamera, fest</translation>
    </message>
    <message>
        <source>Painted sphere</source>
        <translation>Lackierte Kugel</translation>
    </message>
    <message>
        <source>Photograph a painted sphere under a lamp that moves around it, several exposures at each position. Open the folder of the photographs, or try the steps with simulated ones.</source>
        <translation>Eine lackierte Kugel unter einer Lampe fotografieren, die sich um sie bewegt, mit mehreren Belichtungen je Position. Den Ordner der Fotos öffnen oder die Schritte mit simulierten Fotos ausprobieren.</translation>
    </message>
    <message>
        <source>Simulate photographs of a blue metallic sphere and take all steps with them; about half a minute</source>
        <translation>Fotos einer blaumetallischen Kugel simulieren und alle Schritte mit ihnen ausführen; etwa eine halbe Minute</translation>
    </message>
    <message>
        <source>Try a Simulated Session</source>
        <translation>Simulierte Sitzung ausprobieren</translation>
    </message>
    <message>
        <source>visible difference</source>
        <translation>sichtbarer Unterschied</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>außerhalb der Toleranz</translation>
    </message>
    <message>
        <source>{name} (copy)</source>
        <translation>{name} (Kopie)</translation>
    </message>
    <message>
        <source>“{name}” comes with the suite and cannot be changed.</source>
        <translation>„{name}“ gehört zur Suite und kann nicht geändert werden.</translation>
    </message>
    <message>
        <source>Make an Editable Copy</source>
        <translation>Bearbeitbare Kopie anlegen</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Close {name}</source>
        <translation>{name} schließen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Tabs of the panel</source>
        <translation>Reiter des Bedienfelds</translation>
    </message>
    <message>
        <source>Show or hide the lobes in the plane of the light</source>
        <translation>Die Keulen in der Ebene des Lichts ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Reflectance in the plane of the light, as seen from each side; the radius is its cube root. Solid: the model; dashed: the fitted lobes.</source>
        <translation>Reflexion in der Ebene des Lichts, aus jeder Richtung gesehen; der Radius ist ihre dritte Wurzel. Durchgezogen: das Modell; gestrichelt: die angepassten Keulen.</translation>
    </message>
    <message>
        <source>Lobes in the plane of the light</source>
        <translation>Keulen in der Ebene des Lichts</translation>
    </message>
    <message>
        <source>No lobes yet</source>
        <translation>Noch keine Keulen</translation>
    </message>
    <message>
        <source>The paint, drawn by the renderer of Viewer. Drag orbits, Shift drag pans, wheel zooms, Alt drag or right drag rotates the light, F frames.</source>
        <translation>Der Lack, gezeichnet vom Renderer des Viewers. Ziehen umkreist, Ziehen mit Umschalt verschiebt, das Mausrad zoomt, Ziehen mit Alt oder der rechten Taste dreht das Licht, F füllt das Bild.</translation>
    </message>
    <message>
        <source>⚠ Last possible paint</source>
        <translation>⚠ Letzter möglicher Lack</translation>
    </message>
    <message>
        <source>No picture: OpenGL is not available on this screen. Numbers, patches and curves are complete. Open the paint file in Viewer on another computer to see it.</source>
        <translation>Kein Bild: OpenGL ist auf diesem Bildschirm nicht verfügbar. Zahlen, Farbfelder und Kurven sind vollständig. Öffnen Sie die Lackdatei auf einem anderen Rechner im Viewer, um ihn zu sehen.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Nothing matches.</source>
        <translation>Nichts passt.</translation>
    </message>
    <message>
        <source>Show or hide the paints to choose from</source>
        <translation>Lacke zur Auswahl ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Not listed, as they have no readings to edit: {count} of {whole} paints of the palette.</source>
        <translation>Nicht aufgeführt, da ohne bearbeitbare Messwerte: {count} von {whole} Lacken der Palette.</translation>
    </message>
    <message>
        <source>The list of paints is unchanged.</source>
        <translation>Die Liste der Lacke ist unverändert.</translation>
    </message>
    <message>
        <source>what was dropped</source>
        <translation>das Abgelegte</translation>
    </message>
    <message>
        <source>What was dropped is no paint.</source>
        <translation>Das Abgelegte ist kein Lack.</translation>
    </message>
    <message>
        <source>Click on the surface where the highlight is to be – Esc cancels</source>
        <translation>Dort auf die Oberfläche klicken, wo das Glanzlicht sein soll – Esc bricht ab</translation>
    </message>
    <message>
        <source>Light turned to {angle:.0f}° – in the picture, drag with Alt or with the right button</source>
        <translation>Licht auf {angle:.0f}° gedreht – im Bild: mit Alt oder mit der rechten Taste ziehen</translation>
    </message>
    <message>
        <source>Lamp {number}: azimuth {azimuth:.0f}°, elevation {elevation:.0f}°</source>
        <translation>Lampe {number}: Azimut {azimuth:.0f}°, Höhe {elevation:.0f}°</translation>
    </message>
    <message>
        <source>Lamps as handles in the picture while their settings are in sight; drag one to move its lamp</source>
        <translation>Lampen als Griffe im Bild, solange ihre Einstellungen zu sehen sind; ein Griff zieht seine Lampe mit</translation>
    </message>
    <message>
        <source>&amp;Lamps in the Picture</source>
        <translation>&amp;Lampen im Bild</translation>
    </message>
    <message>
        <source>The next click on the surface moves the lamp to where its reflection is seen there</source>
        <translation>Der nächste Klick auf die Oberfläche bringt die Lampe dorthin, wo ihre Spiegelung an dieser Stelle zu sehen ist</translation>
    </message>
    <message>
        <source>Put the &amp;Highlight Here</source>
        <translation>&amp;Glanzlicht hierher setzen</translation>
    </message>
    <message>
        <source>{material} ({paint})</source>
        <translation>{material} ({paint})</translation>
    </message>
    <message>
        <source>Reset to the File&apos;s Material</source>
        <translation>Auf Material der Datei zurücksetzen</translation>
    </message>
    <message>
        <source>{part} – {material}</source>
        <translation>{part} – {material}</translation>
    </message>
    <message>
        <source>{count} parts</source>
        <translation>{count} Teile</translation>
    </message>
    <message>
        <source>Paint – with Ctrl: second paint of {parts}</source>
        <translation>Lack – mit Strg: zweiter Lack von {parts}</translation>
    </message>
    <message>
        <source>Second paint of {parts}</source>
        <translation>Zweiter Lack von {parts}</translation>
    </message>
    <message>
        <source>Looks Right</source>
        <translation>Passt so</translation>
    </message>
    <message>
        <source>Is it upright, the right size, and fine enough?</source>
        <translation>Steht es aufrecht, stimmt die Größe, und ist es fein genug?</translation>
    </message>
    <message>
        <source>Is it upright, and the right size?</source>
        <translation>Steht es aufrecht, und stimmt die Größe?</translation>
    </message>
    <message>
        <source>Now {width} × {depth} m, {height} m high</source>
        <translation>Jetzt {width} × {depth} m, {height} m hoch</translation>
    </message>
    <message>
        <source>Open {name}</source>
        <translation>{name} öffnen</translation>
    </message>
    <message>
        <source>Loading {program}…</source>
        <translation>{program} wird geladen …</translation>
    </message>
    <message>
        <source>No palette is open whose paints could be saved in a project.</source>
        <translation>Keine Palette ist offen, deren Lacke in einem Projekt gespeichert werden könnten.</translation>
    </message>
    <message>
        <source>Pro&amp;ject</source>
        <translation>Pro&amp;jekt</translation>
    </message>
    <message>
        <source>Light: {name}</source>
        <translation>Licht: {name}</translation>
    </message>
    <message>
        <source>thick line: what this paint can reach</source>
        <translation>dicke Linie: was dieser Lack erreicht</translation>
    </message>
    <message>
        <source>outside what this paint can reach</source>
        <translation>außerhalb dessen, was dieser Lack erreicht</translation>
    </message>
    <message>
        <source>Thin line: the edge of the screen&apos;s colours ({screen}). Thick line: what the paint model can reach at this angle while the other angles stay. Colours beyond are faded.</source>
        <translation>Dünne Linie: Rand der Farben des Bildschirms ({screen}). Dicke Linie: was das Lackmodell an diesem Winkel erreicht, während die anderen Winkel bleiben. Farben jenseits davon sind verblasst.</translation>
    </message>
    <message>
        <source>Lightness of the plane</source>
        <translation>Helligkeit der Ebene</translation>
    </message>
    <message>
        <source>Standard:
L* {lightness}
C* {chroma}
h {hue}°</source>
        <translation>Bezug:
L* {lightness}
C* {chroma}
h {hue}°</translation>
    </message>
    <message>
        <source>thin line: {screen}</source>
        <translation>dünne Linie: {screen}</translation>
    </message>
    <message>
        <source>Edit the colour at {angle}</source>
        <translation>Farbe bei {angle} bearbeiten</translation>
    </message>
    <message>
        <source>a* to the right, b* up, at the L* of the reading. Drag the handle, or move it with the arrow keys (Shift: fine); a click on a mark goes to that angle, as Page Up and Page Down do. The ring turns the hue of all angles, as Ctrl+Left and Ctrl+Right do.</source>
        <translation>a* nach rechts, b* nach oben, beim L* des Messwerts. Den Griff ziehen oder mit den Pfeiltasten bewegen (Umschalt: fein); ein Klick auf eine Marke wechselt zu diesem Winkel, ebenso Bild auf und Bild ab. Der Ring dreht den Buntton aller Winkel, ebenso Strg+Links und Strg+Rechts.</translation>
    </message>
    <message>
        <source>Chroma and hue at {angle}</source>
        <translation>Buntheit und Buntton bei {angle}</translation>
    </message>
    <message>
        <source>The paint in another light</source>
        <translation>Der Lack in einem anderen Licht</translation>
    </message>
    <message>
        <source>Lobe Visualizer closed unexpectedly. Reopen the reflectances that were open: {names}?</source>
        <translation>Lobe Visualizer wurde unerwartet beendet. Die zuletzt offenen Reflexionen wieder öffnen: {names}?</translation>
    </message>
    <message>
        <source>the calibration by photographs of a board</source>
        <translation>die Kalibrierung mit Fotos einer Tafel</translation>
    </message>
    <message>
        <source>a session whose session.json states the camera&apos;s intrinsics needs no board</source>
        <translation>eine Sitzung, deren session.json die Kennwerte der Kamera angibt, braucht keine Tafel</translation>
    </message>
    <message>
        <source>not a calibration of a camera ({0})</source>
        <translation>keine Kalibrierung einer Kamera ({0})</translation>
    </message>
    <message>
        <source>There are no photographs of the board.</source>
        <translation>Es gibt keine Fotos der Tafel.</translation>
    </message>
    <message>
        <source>board in {0}</source>
        <translation>Tafel in {0}</translation>
    </message>
    <message>
        <source>{0}: the photograph has {1} × {2} pixels</source>
        <translation>{0}: Das Foto hat {1} × {2} Pixel</translation>
    </message>
    <message>
        <source>{0}, {1} has {2} × {3}.</source>
        <translation>{0}, {1} hat {2} × {3}.</translation>
    </message>
    <message>
        <source>no board of {0} × {1} inner corners was found in it</source>
        <translation>keine Tafel mit {0} × {1} inneren Ecken darin gefunden</translation>
    </message>
    <message>
        <source>intrinsics</source>
        <translation>innere Kennwerte</translation>
    </message>
    <message>
        <source>its corners lie {0} pixels from where the others put them</source>
        <translation>ihre Ecken liegen {0} Pixel neben der Stelle, die sich aus den anderen ergibt</translation>
    </message>
    <message>
        <source>The photographs of the board contradict each other by {0} pixels: {1} … {2}. Is the board flat, and was focus or zoom changed between them?</source>
        <translation>Die Fotos der Tafel widersprechen einander um {0} Pixel: {1} … {2}. Ist die Tafel eben, und wurden Schärfe oder Brennweite dazwischen geändert?</translation>
    </message>
    <message>
        <source>there are no more</source>
        <translation>es gibt keine weiteren</translation>
    </message>
    <message>
        <source>The board with {0} × {1} inner corners is of use in {2} photographs; {3} are needed, better ten ({4}).</source>
        <translation>Die Tafel mit {0} × {1} inneren Ecken ist in {2} Fotos verwendbar; {3} werden gebraucht, besser zehn ({4}).</translation>
    </message>
    <message>
        <source>OpenCV cannot calibrate the camera: {0}.</source>
        <translation>OpenCV kann die Kamera nicht kalibrieren: {0}.</translation>
    </message>
    <message>
        <source>sphere&apos;s centre, to the right</source>
        <translation>Kugelmittelpunkt, nach rechts</translation>
    </message>
    <message>
        <source>Determined by the outline. A highlight moves with the sphere at any angle of the light, but also with the turntable&apos;s zero; only their difference over the half turn distinguishes them.</source>
        <translation>Durch den Umriss bestimmt. Ein Glanzlicht wandert bei jedem Winkel des Lichts mit der Kugel, aber auch mit dem Nullpunkt des Drehtellers; nur ihr Unterschied über die halbe Drehung trennt sie.</translation>
    </message>
    <message>
        <source>sphere&apos;s centre, downward</source>
        <translation>Kugelmittelpunkt, nach unten</translation>
    </message>
    <message>
        <source>Determined by the outline. The highlights add little, as the light&apos;s height moves them alike.</source>
        <translation>Durch den Umriss bestimmt. Die Glanzlichter tragen wenig bei, da die Höhe des Lichts sie ebenso verschiebt.</translation>
    </message>
    <message>
        <source>sphere&apos;s centre, away from the camera</source>
        <translation>Kugelmittelpunkt, von der Kamera weg</translation>
    </message>
    <message>
        <source>Determined by the size of the outline, from the sphere&apos;s radius. Highlights far from the middle of the sphere determine the size as well.</source>
        <translation>Durch die Größe des Umrisses bestimmt, aus dem Kugelradius. Auch Glanzlichter weit außerhalb der Kugelmitte bestimmen die Größe.</translation>
    </message>
    <message>
        <source>turntable&apos;s zero</source>
        <translation>Nullpunkt des Drehtellers</translation>
    </message>
    <message>
        <source>Moves every highlight along the sphere, by half the angle; the best observed of all.</source>
        <translation>Verschiebt jedes Glanzlicht entlang der Kugel, um den halben Winkel; von allen am besten beobachtet.</translation>
    </message>
    <message>
        <source>light&apos;s height</source>
        <translation>Höhe des Lichts</translation>
    </message>
    <message>
        <source>Raises every highlight alike; well observed as an angle, in metres as well as the light&apos;s distance is known.</source>
        <translation>Hebt jedes Glanzlicht gleich; als Winkel gut beobachtet, in Metern so gut, wie der Abstand des Lichts bekannt ist.</translation>
    </message>
    <message>
        <source>light&apos;s distance</source>
        <translation>Abstand des Lichts</translation>
    </message>
    <message>
        <source>Hardly observed: with it all directions to the light stay the same but for the parallax between points of the sphere, of the order of radius over distance. It enters the irradiance, which is measured at the axis.</source>
        <translation>Kaum beobachtbar: Alle Richtungen zum Licht bleiben dabei gleich, bis auf die Parallaxe zwischen Punkten der Kugel, in der Größe von Radius durch Abstand. Der Wert geht in die Bestrahlungsstärke ein, die an der Achse gemessen wird.</translation>
    </message>
    <message>
        <source>turntable&apos;s tilt to the camera</source>
        <translation>Neigung des Drehtellers zur Kamera</translation>
    </message>
    <message>
        <source>Raises the highlights in front and lowers those behind, as the cosine of the angle; the light&apos;s height does it alike at all angles.</source>
        <translation>Hebt die Glanzlichter vorn und senkt die hinten, wie der Kosinus des Winkels; die Höhe des Lichts tut es bei allen Winkeln gleich.</translation>
    </message>
    <message>
        <source>turntable&apos;s tilt to the right</source>
        <translation>Neigung des Drehtellers nach rechts</translation>
    </message>
    <message>
        <source>Lowers the highlights at 90° against those in front and behind; without positions beyond 90° it looks like the light&apos;s height.</source>
        <translation>Senkt die Glanzlichter bei 90° gegenüber denen vorn und hinten; ohne Stellungen jenseits von 90° sieht es wie die Höhe des Lichts aus.</translation>
    </message>
    <message>
        <source>sphere off the axis, to the right</source>
        <translation>Kugel neben der Achse, nach rechts</translation>
    </message>
    <message>
        <source>Turns the light by the offset over its distance in front and behind and not at 90°: weakly observed, and weak in its effect.</source>
        <translation>Dreht das Licht vorn und hinten um den Versatz durch seinen Abstand, bei 90° nicht: schwach beobachtet und schwach in der Wirkung.</translation>
    </message>
    <message>
        <source>sphere off the axis, to the camera</source>
        <translation>Kugel neben der Achse, zur Kamera</translation>
    </message>
    <message>
        <source>Turns the light at 90° and not in front and behind; half of it looks like the turntable&apos;s zero.</source>
        <translation>Dreht das Licht bei 90° und nicht vorn und hinten; zur Hälfte sieht es wie der Nullpunkt des Drehtellers aus.</translation>
    </message>
    <message>
        <source>refining the light&apos;s position</source>
        <translation>Lage des Lichts wird verfeinert</translation>
    </message>
    <message>
        <source>The light&apos;s mirror image was found at {0} positions of the light; refining its place needs 4. Free the highlights in the mask, or continue without refinement.</source>
        <translation>Das Spiegelbild des Lichts wurde in {0} Stellungen des Lichts gefunden; um seine Lage zu verfeinern, werden 4 gebraucht. Geben Sie die Glanzlichter in der Maske frei, oder fahren Sie ohne Verfeinerung fort.</translation>
    </message>
    <message>
        <source>The sphere has moved by {0} pixels between {1} and {2}.</source>
        <translation>Die Kugel hat sich zwischen {1} und {2} um {0} Pixel bewegt.</translation>
    </message>
    <message>
        <source>{0}The geometry is that of the longest part without movement; {1} positions are not of it.</source>
        <translation>{0}Die Geometrie ist die des längsten Teils ohne Bewegung; {1} Stellungen gehören nicht dazu.</translation>
    </message>
    <message>
        <source>looking for the sphere</source>
        <translation>Kugel wird gesucht</translation>
    </message>
    <message>
        <source>measuring the sphere&apos;s outline</source>
        <translation>Umriss der Kugel wird gemessen</translation>
    </message>
    <message>
        <source>The sphere&apos;s outline was not found. It is seen where the light reaches it from the side: add positions of the light between 40° and 150°, and check the radius, the camera&apos;s distance and the mask.</source>
        <translation>Der Umriss der Kugel wurde nicht gefunden. Er ist zu sehen, wo das Licht ihn von der Seite trifft: Fügen Sie Stellungen des Lichts zwischen 40° und 150° hinzu, und prüfen Sie den Radius, den Kameraabstand und die Maske.</translation>
    </message>
    <message>
        <source>Too little of the sphere&apos;s outline is lit or free to locate its centre. Add light positions between 40° and 150°, or free more of the sphere in the mask.</source>
        <translation>Vom Umriss der Kugel ist zu wenig beleuchtet oder frei, um ihren Mittelpunkt zu finden. Fügen Sie Stellungen des Lichts zwischen 40° und 150° hinzu, oder geben Sie in der Maske mehr von der Kugel frei.</translation>
    </message>
    <message>
        <source>No sphere was found in the photographs. Check the sphere&apos;s radius, the camera&apos;s distance and the mask, and that the background is dark.</source>
        <translation>In den Fotos wurde keine Kugel gefunden. Prüfen Sie den Kugelradius, den Kameraabstand und die Maske, und ob der Hintergrund dunkel ist.</translation>
    </message>
    <message>
        <source>{0} m; the camera stands outside of the sphere</source>
        <translation>{0} m; die Kamera steht außerhalb der Kugel</translation>
    </message>
    <message>
        <source>{0} m; the light stands outside of the sphere</source>
        <translation>{0} m; das Licht steht außerhalb der Kugel</translation>
    </message>
    <message>
        <source>the photograph of {0} s is clipped everywhere and cannot be used</source>
        <translation>das Foto mit {0} s ist überall übersteuert und nicht verwendbar</translation>
    </message>
    <message>
        <source>even the longest exposure, {0} s, shows no light; was the lamp on</source>
        <translation>auch die längste Belichtung, {0} s, zeigt kein Licht; war die Lampe an</translation>
    </message>
    <message>
        <source>it looks like the exposure of {0} s, and {1} like that of {2} s; the two are exchanged</source>
        <translation>es sieht wie die Belichtung mit {0} s aus, und {1} wie die mit {2} s; die beiden sind vertauscht</translation>
    </message>
    <message>
        <source>stated as {0} s, but its pixels show about {1} s</source>
        <translation>mit {0} s angegeben, seine Pixel zeigen aber etwa {1} s</translation>
    </message>
    <message>
        <source>, darker than the {0} s before it</source>
        <translation>, dunkler als das mit {0} s davor</translation>
    </message>
    <message>
        <source>is saturated everywhere, and so are the longer exposures: there is nothing to measure</source>
        <translation>ist überall gesättigt, und die längeren Belichtungen ebenso: Es gibt nichts zu messen</translation>
    </message>
    <message>
        <source>is saturated in {0} of its pixels, background included: other light came in,</source>
        <translation>ist in {0} seiner Pixel gesättigt, auch im Hintergrund: Anderes Licht ist eingefallen,</translation>
    </message>
    <message>
        <source>{0}or it was exposed longer than {1} s</source>
        <translation>{0}oder es wurde länger als {1} s belichtet</translation>
    </message>
    <message>
        <source>is the brightest of its position: the files are in reverse order of their times</source>
        <translation>ist das hellste seiner Stellung: Die Dateien stehen in umgekehrter Reihenfolge ihrer Zeiten</translation>
    </message>
    <message>
        <source>is {0} than {1}, which was exposed for {2} s:</source>
        <translation>ist {0} als {1}, das {2} s belichtet wurde:</translation>
    </message>
    <message>
        <source>{0}the two files or their times were exchanged</source>
        <translation>{0}die beiden Dateien oder ihre Zeiten wurden vertauscht</translation>
    </message>
    <message>
        <source>is not as bright as an exposure of {0} s between its neighbours:</source>
        <translation>ist weniger hell als eine Belichtung von {0} s zwischen seinen Nachbarn:</translation>
    </message>
    <message>
        <source>{0}its time is wrong, or it shows something else</source>
        <translation>{0}seine Zeit ist falsch, oder es zeigt etwas anderes</translation>
    </message>
    <message>
        <source>and the others are not in order of their times; by brightness they are {0}</source>
        <translation>und die anderen stehen nicht in der Reihenfolge ihrer Zeiten; nach der Helligkeit sind sie {0}</translation>
    </message>
    <message>
        <source>has no end of picture; it was not copied whole</source>
        <translation>hat kein Bildende; es wurde nicht ganz kopiert</translation>
    </message>
    <message>
        <source>byte {0}</source>
        <translation>Byte {0}</translation>
    </message>
    <message>
        <source>has no marker where one belongs; it is damaged</source>
        <translation>hat keine Kennung, wo eine hingehört; es ist beschädigt</translation>
    </message>
    <message>
        <source>has no size; it is a damaged JPEG picture</source>
        <translation>hat keine Größe; es ist ein beschädigtes JPEG-Bild</translation>
    </message>
    <message>
        <source>ends within a chunk, after {0} bytes; it was not copied whole</source>
        <translation>endet in einem Abschnitt, nach {0} Byte; es wurde nicht ganz kopiert</translation>
    </message>
    <message>
        <source>has no header or no pixels; it is damaged</source>
        <translation>hat keinen Kopf oder keine Pixel; es ist beschädigt</translation>
    </message>
    <message>
        <source>has a palette or fewer than 8 bits; a photograph has 8 or 16 bits a channel</source>
        <translation>hat eine Palette oder weniger als 8 Bit; ein Foto hat 8 oder 16 Bit je Kanal</translation>
    </message>
    <message>
        <source>is {0} × {1} pixels; up to {2} are read</source>
        <translation>hat {0} × {1} Pixel; gelesen werden bis zu {2}</translation>
    </message>
    <message>
        <source>its pixels</source>
        <translation>seine Pixel</translation>
    </message>
    <message>
        <source>is interlaced; write it without</source>
        <translation>ist mit Zeilensprung gespeichert; schreiben Sie es ohne</translation>
    </message>
    <message>
        <source>cannot be unpacked ({0}); it is damaged</source>
        <translation>lässt sich nicht entpacken ({0}); es ist beschädigt</translation>
    </message>
    <message>
        <source>holds fewer pixels than its header says; it is damaged</source>
        <translation>enthält weniger Pixel, als sein Kopf angibt; es ist beschädigt</translation>
    </message>
    <message>
        <source>uses a filter {0} that there is not; it is damaged</source>
        <translation>verwendet ein Filter {0}, das es nicht gibt; es ist beschädigt</translation>
    </message>
    <message>
        <source>is empty; it was not copied whole</source>
        <translation>ist leer; es wurde nicht ganz kopiert</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>cannot be read ({0})</source>
        <translation>ist nicht lesbar ({0})</translation>
    </message>
    <message>
        <source>PNG, TIFF, JPEG, OpenEXR, Radiance or a camera&apos;s raw file</source>
        <translation>PNG, TIFF, JPEG, OpenEXR, Radiance oder die Rohdatei einer Kamera</translation>
    </message>
    <message>
        <source>is no photograph that is read here: {0}</source>
        <translation>ist kein lesbares Foto: {0}</translation>
    </message>
    <message>
        <source>holds values that are no numbers (NaN or infinite)</source>
        <translation>enthält Werte, die keine Zahlen sind (NaN oder unendlich)</translation>
    </message>
    <message>
        <source>has {0} channels; expected grey or red, green, blue</source>
        <translation>hat {0} Kanäle; erwartet wurde Grau oder Rot, Grün, Blau</translation>
    </message>
    <message>
        <source>a camera&apos;s raw file</source>
        <translation>die Rohdatei einer Kamera</translation>
    </message>
    <message>
        <source>a TIFF of 16 bits needs nothing more</source>
        <translation>ein TIFF mit 16 Bit braucht nichts weiter</translation>
    </message>
    <message>
        <source>cannot be read as a raw file ({0})</source>
        <translation>ist nicht als Rohdatei lesbar ({0})</translation>
    </message>
    <message>
        <source>holds no picture</source>
        <translation>enthält kein Bild</translation>
    </message>
    <message>
        <source>lacks the fields of its size and depth; it is damaged or no photograph</source>
        <translation>hat die Felder seiner Größe und Tiefe nicht; es ist beschädigt oder kein Foto</translation>
    </message>
    <message>
        <source>holds {0} values where one number belongs; the file is damaged</source>
        <translation>enthält {0} Werte, wo eine Zahl hingehört; die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>field {0}</source>
        <translation>Feld {0}</translation>
    </message>
    <message>
        <source>has {0} channels; up to {1} are read</source>
        <translation>hat {0} Kanäle; gelesen werden bis zu {1}</translation>
    </message>
    <message>
        <source>field ImageWidth</source>
        <translation>Feld ImageWidth</translation>
    </message>
    <message>
        <source>is a volume of {0} pictures; a photograph is one</source>
        <translation>ist ein Volumen von {0} Bildern; ein Foto ist eines</translation>
    </message>
    <message>
        <source>names fewer strips than its pixels need; it is damaged</source>
        <translation>nennt weniger Streifen, als seine Pixel brauchen; es ist beschädigt</translation>
    </message>
    <message>
        <source>ends at byte {0}, its pixels at {1}; it was not copied whole</source>
        <translation>endet bei Byte {0}, seine Pixel bei {1}; es wurde nicht ganz kopiert</translation>
    </message>
    <message>
        <source>has numbers of {0} bits in a form that is not read; write 8 or 16 bits, or floats</source>
        <translation>hat Zahlen mit {0} Bit in einer Form, die nicht gelesen wird; schreiben Sie 8 oder 16 Bit oder Gleitkommazahlen</translation>
    </message>
    <message>
        <source>field SampleFormat</source>
        <translation>Feld SampleFormat</translation>
    </message>
    <message>
        <source>has tiles of {0} × {1} pixels; it is damaged</source>
        <translation>hat Kacheln von {0} × {1} Pixeln; es ist beschädigt</translation>
    </message>
    <message>
        <source>has a strip that is too short; it is damaged</source>
        <translation>hat einen zu kurzen Streifen; es ist beschädigt</translation>
    </message>
    <message>
        <source>has a strip that cannot be unpacked ({0}); it is damaged</source>
        <translation>hat einen Streifen, der sich nicht entpacken lässt ({0}); es ist beschädigt</translation>
    </message>
    <message>
        <source>has a strip that unpacks to more than its pixels; it is damaged</source>
        <translation>hat einen Streifen, der entpackt mehr als seine Pixel ergibt; es ist beschädigt</translation>
    </message>
    <message>
        <source>this packing of a TIFF</source>
        <translation>diese Packung eines TIFF</translation>
    </message>
    <message>
        <source>a TIFF without compression needs nothing more</source>
        <translation>ein TIFF ohne Kompression braucht nichts weiter</translation>
    </message>
    <message>
        <source>is a TIFF that OpenCV cannot unpack; write it without compression</source>
        <translation>ist ein TIFF, das OpenCV nicht entpacken kann; schreiben Sie es ohne Kompression</translation>
    </message>
    <message>
        <source>is a TIFF that cannot be unpacked; write it without compression</source>
        <translation>ist ein TIFF, das sich nicht entpacken lässt; schreiben Sie es ohne Kompression</translation>
    </message>
    <message>
        <source>ends before its fields do; it was not copied whole</source>
        <translation>endet vor seinen Feldern; es wurde nicht ganz kopiert</translation>
    </message>
    <message>
        <source>is a damaged TIFF; its fields contradict each other ({0})</source>
        <translation>ist ein beschädigtes TIFF; seine Felder widersprechen einander ({0})</translation>
    </message>
    <message>
        <source>the shape {0} does not fit {1} exposure times</source>
        <translation>die Form {0} passt nicht zu {1} Belichtungszeiten</translation>
    </message>
    <message>
        <source>photographs of whole codes need the response of their camera</source>
        <translation>Fotos mit ganzen Codes brauchen die Kennlinie ihrer Kamera</translation>
    </message>
    <message>
        <source>it has {0} channels, the photographs {1}</source>
        <translation>sie hat {0} Kanäle, die Fotos {1}</translation>
    </message>
    <message>
        <source>expected codes of 8 or 16 bits or floats, not {0}</source>
        <translation>erwartet wurden Codes mit 8 oder 16 Bit oder Gleitkommazahlen, nicht {0}</translation>
    </message>
    <message>
        <source>it holds codes above the {0} of {1} bits</source>
        <translation>es enthält Codes über den {0} von {1} Bit</translation>
    </message>
    <message>
        <source>exposure {0} is not a number at column {1}, row {2}</source>
        <translation>Belichtung {0} ist in Spalte {1}, Zeile {2} keine Zahl</translation>
    </message>
    <message>
        <source>the shape is {0}, the pictures&apos; is {1}</source>
        <translation>die Form ist {0}, die der Bilder {1}</translation>
    </message>
    <message>
        <source>clipped or dark</source>
        <translation>übersteuert oder dunkel</translation>
    </message>
    <message>
        <source>The flat field is {0} in {1} % of its pixels; the screen must fill the picture, with an exposure that is neither.</source>
        <translation>Das Hellfeld ist in {1} % seiner Pixel {0}; die Streuwand muss das Bild füllen, mit einer Belichtung, bei der beides nicht vorkommt.</translation>
    </message>
    <message>
        <source>the screen does not fill it evenly</source>
        <translation>die Streuwand füllt es nicht gleichmäßig</translation>
    </message>
    <message>
        <source>The flat field falls to nothing within the picture; {0}.</source>
        <translation>Das Hellfeld fällt im Bild auf nichts ab; {0}.</translation>
    </message>
    <message>
        <source>The session names no white reference.</source>
        <translation>Die Sitzung nennt keine Weißreferenz.</translation>
    </message>
    <message>
        <source>The white reference ({0} …) is dark where it should show the white</source>
        <translation>Die Weißreferenz ({0} …) ist dunkel, wo sie das Weiß zeigen sollte</translation>
    </message>
    <message>
        <source>{0}: check its region.</source>
        <translation>{0}: Prüfen Sie ihren Bereich.</translation>
    </message>
    <message>
        <source>The lamp at {0}° does not light the white reference, which faces ({1}, {2}, {3}): check white.angle_deg and white.normal.</source>
        <translation>Die Lampe bei {0}° beleuchtet die Weißreferenz nicht, die nach ({1}, {2}, {3}) zeigt: Prüfen Sie white.angle_deg und white.normal.</translation>
    </message>
    <message>
        <source>Light and sphere could not be corrected by highlights, and stand as stated</source>
        <translation>Licht und Kugel konnten nicht anhand der Glanzlichter berichtigt werden und bleiben wie angegeben</translation>
    </message>
    <message>
        <source>The sphere&apos;s outline is that of all positions, before and after it moved</source>
        <translation>Der Umriss der Kugel ist der aller Stellungen, vor und nach ihrer Bewegung</translation>
    </message>
    <message>
        <source>the sphere has moved and stands elsewhere here</source>
        <translation>die Kugel hat sich bewegt und steht hier anderswo</translation>
    </message>
    <message>
        <source>reading for the geometry</source>
        <translation>für die Geometrie lesen</translation>
    </message>
    <message>
        <source>None of the positions that light the sphere&apos;s outline can be read.</source>
        <translation>Keine der Stellungen, die den Umriss der Kugel beleuchten, ist lesbar.</translation>
    </message>
    <message>
        <source>The scale is unknown: the session states no irradiance and has no white reference, so the table is right but for one factor per channel.</source>
        <translation>Der Maßstab ist unbekannt: Die Sitzung gibt keine Bestrahlungsstärke an und hat keine Weißreferenz; die Tabelle stimmt daher bis auf einen Faktor je Kanal.</translation>
    </message>
    <message>
        <source>The white reference ({0} …) is saturated in all exposures.</source>
        <translation>Die Weißreferenz ({0} …) ist in allen Belichtungen gesättigt.</translation>
    </message>
    <message>
        <source>{0}°; 30° to less than 90° are wanted</source>
        <translation>{0}°; verlangt sind 30° bis unter 90°</translation>
    </message>
    <message>
        <source>{0}; auto or linear are known</source>
        <translation>{0}; bekannt sind auto und linear</translation>
    </message>
    <message>
        <source>checking the files</source>
        <translation>Dateien werden geprüft</translation>
    </message>
    <message>
        <source>holds no finished position, so there is nothing to write yet</source>
        <translation>enthält keine fertige Stellung; es gibt noch nichts zu schreiben</translation>
    </message>
    <message>
        <source>a table goes into one of {0}; give it one of these endings</source>
        <translation>eine Tabelle kommt in eines von {0}; geben Sie ihr eine dieser Endungen</translation>
    </message>
    <message>
        <source>coverage and uncertainty are not held by this format</source>
        <translation>Abdeckung und Unsicherheit speichert dieses Format nicht</translation>
    </message>
    <message>
        <source>{0}; the session has positions 0 to {1}</source>
        <translation>{0}; die Sitzung hat die Stellungen 0 bis {1}</translation>
    </message>
    <message>
        <source>none is asked for</source>
        <translation>keine wird verlangt</translation>
    </message>
    <message>
        <source>has the shape {0}; that of the session has {1}</source>
        <translation>hat die Form {0}; die der Sitzung ist {1}</translation>
    </message>
    <message>
        <source>The response comes first; it was not calibrated yet.</source>
        <translation>Zuerst kommt die Kennlinie; sie wurde noch nicht kalibriert.</translation>
    </message>
    <message>
        <source>photographs are linear (float files)</source>
        <translation>die Fotos sind linear (Gleitkommadateien)</translation>
    </message>
    <message>
        <source>sRGB, as the session states</source>
        <translation>sRGB, wie die Sitzung angibt</translation>
    </message>
    <message>
        <source>reading for the response</source>
        <translation>für die Kennlinie lesen</translation>
    </message>
    <message>
        <source>Response and geometry come first; one of them was not calibrated yet.</source>
        <translation>Zuerst kommen Kennlinie und Geometrie; eine davon wurde noch nicht kalibriert.</translation>
    </message>
    <message>
        <source>was begun with another calibration; take that one, or begin anew</source>
        <translation>wurde mit einer anderen Kalibrierung begonnen; nehmen Sie diese, oder beginnen Sie neu</translation>
    </message>
    <message>
        <source>{0}go on with those, or begin anew (--restart)</source>
        <translation>{0}machen Sie mit ihnen weiter, oder beginnen Sie neu (--restart)</translation>
    </message>
    <message>
        <source>The coat&apos;s peak is narrower than these photographs resolve: it is {0}° wide at half of its height, and a pixel covers {1}° of the sphere, so its height and the sharp lobe&apos;s ks, m and r are not reliable. Photograph the sphere about {2} times as large: with more pixels, a longer lens, or the camera nearer.</source>
        <translation>Die Spitze des Klarlacks ist schmaler, als diese Fotos auflösen: Sie ist in halber Höhe {0}° breit, und ein Pixel deckt {1}° der Kugel ab; ihre Höhe und ks, m und r der scharfen Keule sind daher nicht verlässlich. Fotografieren Sie die Kugel etwa {2}-mal so groß: mit mehr Pixeln, einem längeren Objektiv oder der Kamera näher daran.</translation>
    </message>
    <message>
        <source>position {0} of {1}</source>
        <translation>Stellung {0} von {1}</translation>
    </message>
    <message>
        <source>The first: {0}</source>
        <translation>Die erste: {0}</translation>
    </message>
    <message>
        <source>No position gave a reading.{0}</source>
        <translation>Keine Stellung ergab einen Wert.{0}</translation>
    </message>
    <message>
        <source>filling holes</source>
        <translation>Lücken werden gefüllt</translation>
    </message>
    <message>
        <source>work file of a reconstruction</source>
        <translation>Arbeitsdatei einer Rekonstruktion</translation>
    </message>
    <message>
        <source>is no work file of a reconstruction and is left as it is</source>
        <translation>ist keine Arbeitsdatei einer Rekonstruktion und bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>ist nicht lesbar: {0}</translation>
    </message>
    <message>
        <source>cannot be written: {0}</source>
        <translation>lässt sich nicht schreiben: {0}</translation>
    </message>
    <message>
        <source>is in use: another program reconstructs into it</source>
        <translation>ist in Gebrauch: Ein anderes Programm rekonstruiert darin</translation>
    </message>
    <message>
        <source>cannot be opened: {0}</source>
        <translation>lässt sich nicht öffnen: {0}</translation>
    </message>
    <message>
        <source>Too few codes are covered by the photographs to measure their noise.</source>
        <translation>Die Fotos decken zu wenige Codes ab, um ihr Rauschen zu messen.</translation>
    </message>
    <message>
        <source>response of the camera</source>
        <translation>Kennlinie der Kamera</translation>
    </message>
    <message>
        <source>Channel {0} has only {1} pixels with two exposures that are neither black nor clipped</source>
        <translation>Kanal {0} hat nur {1} Pixel mit zwei Belichtungen, die weder schwarz noch übersteuert sind</translation>
    </message>
    <message>
        <source>{0}; the response of the camera cannot be recovered from them.</source>
        <translation>{0}; die Kennlinie der Kamera lässt sich daraus nicht ermitteln.</translation>
    </message>
    <message>
        <source>of the stated curve</source>
        <translation>nach der angegebenen Kennlinie</translation>
    </message>
    <message>
        <source>The photographs are not {0}: their pixels show times of exposure that differ from the stated ones by up to a factor of {1}. Let the response be recovered (unknown), or check the times.</source>
        <translation>Die Fotos sind nicht {0}: Ihre Pixel zeigen Belichtungszeiten, die von den angegebenen um einen Faktor von bis zu {1} abweichen. Lassen Sie die Kennlinie ermitteln (unbekannt), oder prüfen Sie die Zeiten.</translation>
    </message>
    <message>
        <source>the shape is {0}; expected a row of codes</source>
        <translation>die Form ist {0}; erwartet wurde eine Zeile von Codes</translation>
    </message>
    <message>
        <source>exposures must be finite and must not fall as codes grow</source>
        <translation>Belichtungen müssen endlich sein und dürfen mit wachsenden Codes nicht fallen</translation>
    </message>
    <message>
        <source>one finite number of 0 or more for each channel</source>
        <translation>eine endliche Zahl von 0 oder mehr für jeden Kanal</translation>
    </message>
    <message>
        <source>it lies between the lowest and the largest code</source>
        <translation>sie liegt zwischen dem niedrigsten und dem größten Code</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>erwartet wurde eine ganze Zahl</translation>
    </message>
    <message>
        <source>expected numbers for each channel</source>
        <translation>erwartet wurden Zahlen für jeden Kanal</translation>
    </message>
    <message>
        <source>{0} is outside the range 8 to 16</source>
        <translation>{0} liegt außerhalb des Bereichs 8 bis 16</translation>
    </message>
    <message>
        <source>expected two or more exposure times greater than 0</source>
        <translation>erwartet wurden zwei oder mehr Belichtungszeiten über 0</translation>
    </message>
    <message>
        <source>list the exposures from the shortest to the longest</source>
        <translation>führen Sie die Belichtungen von der kürzesten zur längsten auf</translation>
    </message>
    <message>
        <source>the shape is {0}, not ({1}, h, w, {2})</source>
        <translation>die Form ist {0}, nicht ({1}, h, w, {2})</translation>
    </message>
    <message>
        <source>expected codes, not {0}</source>
        <translation>erwartet wurden Codes, nicht {0}</translation>
    </message>
    <message>
        <source>the {0} of {1} bits</source>
        <translation>die {0} von {1} Bit</translation>
    </message>
    <message>
        <source>A photograph holds the code {0}, above {1}.</source>
        <translation>Ein Foto enthält den Code {0}, über {1}.</translation>
    </message>
    <message>
        <source>and the others show the highlight go to the left as the angles grow: they are mirrored, or the angles have the wrong sign</source>
        <translation>und in den anderen wandert das Glanzlicht mit wachsenden Winkeln nach links: Sie sind gespiegelt, oder die Winkel haben das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>shows the highlight at column {0}, {1}</source>
        <translation>zeigt das Glanzlicht in Spalte {0}, {1}</translation>
    </message>
    <message>
        <source>: does it belong to another position?</source>
        <translation>: Gehört es zu einer anderen Stellung?</translation>
    </message>
    <message>
        <source>before that of {0}°</source>
        <translation>vor dem von {0}°</translation>
    </message>
    <message>
        <source>beyond that of {0}°</source>
        <translation>jenseits des von {0}°</translation>
    </message>
    <message>
        <source>between those of {0}° and {1}°</source>
        <translation>zwischen denen von {0}° und {1}°</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>geprüft</translation>
    </message>
    <message>
        <source>file {0} of {1}</source>
        <translation>Datei {0} von {1}</translation>
    </message>
    <message>
        <source>is {0} pixels, and the others are {1} × {2}</source>
        <translation>hat {0} Pixel, die anderen {1} × {2}</translation>
    </message>
    <message>
        <source>session.json says {0}; correct camera.bit_depth</source>
        <translation>session.json sagt {0}; berichtigen Sie camera.bit_depth</translation>
    </message>
    <message>
        <source>has {0} bits a channel, and {1}</source>
        <translation>hat {0} Bit je Kanal, und {1}</translation>
    </message>
    <message>
        <source>whole codes</source>
        <translation>ganze Codes</translation>
    </message>
    <message>
        <source>holds {0}, and the other photographs hold {1}, in another unit</source>
        <translation>enthält {0}, die anderen Fotos enthalten {1}, in einer anderen Einheit</translation>
    </message>
    <message>
        <source>is not taken off: of floats black is taken to be 0</source>
        <translation>wird nicht abgezogen: Bei Gleitkommazahlen gilt 0 als Schwarz</translation>
    </message>
    <message>
        <source>{0}; none of the {1} photographs of {2} can be used: bring them, or take {3} out of session.json</source>
        <translation>{0}; keines der {1} Fotos von {2} ist verwendbar: Ergänzen Sie sie, oder nehmen Sie {3} aus session.json heraus</translation>
    </message>
    <message>
        <source>has {0} × {1} pixels, and the region {2}, {3}, {4}, {5} (left, top, width, height) goes beyond them</source>
        <translation>hat {0} × {1} Pixel, und der Bereich {2}, {3}, {4}, {5} (links, oben, Breite, Höhe) reicht darüber hinaus</translation>
    </message>
    <message>
        <source>was exposed for {0} s as its EXIF says, and session.json says {1} s</source>
        <translation>wurde laut EXIF {0} s belichtet, laut session.json {1} s</translation>
    </message>
    <message>
        <source>; that is the time of exposure {0}, so that files may have been exchanged</source>
        <translation>; das ist die Zeit der Belichtung {0}, die Dateien können also vertauscht sein</translation>
    </message>
    <message>
        <source>; correct exposures_s</source>
        <translation>; berichtigen Sie exposures_s</translation>
    </message>
    <message>
        <source>is a JPEG, whose codes are never linear; set camera.response to unknown, or write linear TIFF from the raw files</source>
        <translation>ist ein JPEG, dessen Codes nie linear sind; setzen Sie camera.response auf unknown, oder schreiben Sie lineares TIFF aus den Rohdateien</translation>
    </message>
    <message>
        <source>is a JPEG with an unknown curve, and {0} exposures do not determine it; take {1} or more, or set camera.response to srgb where the camera applies just that</source>
        <translation>ist ein JPEG mit unbekannter Kennlinie, und {0} Belichtungen bestimmen sie nicht; nehmen Sie {1} oder mehr, oder setzen Sie camera.response auf srgb, wo die Kamera genau das anwendet</translation>
    </message>
    <message>
        <source>is a JPEG with an unknown curve: it is recovered from the exposures, to 8 bits, and holds only if the camera treated all photographs alike (no automatic contrast)</source>
        <translation>ist ein JPEG mit unbekannter Kennlinie: Sie wird aus den Belichtungen ermittelt, auf 8 Bit genau, und gilt nur, wenn die Kamera alle Fotos gleich behandelt hat (kein automatischer Kontrast)</translation>
    </message>
    <message>
        <source>{0}; none of the {1} photographs at {2}° can be used</source>
        <translation>{0}; keines der {1} Fotos bei {2}° ist verwendbar</translation>
    </message>
    <message>
        <source>none of its photographs can be used; see the files named before</source>
        <translation>keines der Fotos ist verwendbar; siehe die zuvor genannten Dateien</translation>
    </message>
    <message>
        <source>is {0}, and the photographs before it are {1}</source>
        <translation>ist {0}, die Fotos davor sind {1}</translation>
    </message>
    <message>
        <source>names no photograph that could be read</source>
        <translation>nennt kein Foto, das lesbar war</translation>
    </message>
    <message>
        <source>has {0} bits a channel, and session.json says {1}; correct camera.bit_depth</source>
        <translation>hat {0} Bit je Kanal, und session.json sagt {1}; berichtigen Sie camera.bit_depth</translation>
    </message>
    <message>
        <source>{0}correct camera.bit_depth in session.json</source>
        <translation>{0}berichtigen Sie camera.bit_depth in session.json</translation>
    </message>
    <message>
        <source>is {0}, and the session&apos;s mask is {1}</source>
        <translation>ist {0}, die Maske der Sitzung ist {1}</translation>
    </message>
    <message>
        <source>{0} × {1} pixels{2}</source>
        <translation>{0} × {1} Pixel{2}</translation>
    </message>
    <message>
        <source>expected three rows of three numbers, not {0}</source>
        <translation>erwartet wurden drei Zeilen mit drei Zahlen, nicht {0}</translation>
    </message>
    <message>
        <source>the row sums to {0}, not to 1, so that white would change</source>
        <translation>die Zeile hat die Summe {0}, nicht 1, sodass sich Weiß ändern würde</translation>
    </message>
    <message>
        <source>expected a list of pairs, not {0}</source>
        <translation>erwartet wurde eine Liste von Paaren, nicht {0}</translation>
    </message>
    <message>
        <source>expected a pair, not {0}</source>
        <translation>erwartet wurde ein Paar, nicht {0}</translation>
    </message>
    <message>
        <source>{0}° is not beyond the one before</source>
        <translation>{0}° liegt nicht jenseits des vorigen</translation>
    </message>
    <message>
        <source>the profile starts at 0°, not at {0}°</source>
        <translation>das Profil beginnt bei 0°, nicht bei {0}°</translation>
    </message>
    <message>
        <source>expected left, top, width, height, not {0}</source>
        <translation>erwartet wurden links, oben, Breite, Höhe, nicht {0}</translation>
    </message>
    <message>
        <source>a vector of length 0 has no direction</source>
        <translation>ein Vektor der Länge 0 hat keine Richtung</translation>
    </message>
    <message>
        <source>the list is empty</source>
        <translation>die Liste ist leer</translation>
    </message>
    <message>
        <source>the camera would stand inside the sphere</source>
        <translation>die Kamera stünde im Inneren der Kugel</translation>
    </message>
    <message>
        <source>the lamp would stand inside the sphere</source>
        <translation>die Lampe stünde im Inneren der Kugel</translation>
    </message>
    <message>
        <source>expected a list of positions, not {0}</source>
        <translation>erwartet wurde eine Liste von Stellungen, nicht {0}</translation>
    </message>
    <message>
        <source>expected 1 to {0}, found {1}</source>
        <translation>erwartet wurden 1 bis {0}, gefunden {1}</translation>
    </message>
    <message>
        <source>{0}° comes after {1}°; list the positions in order of their angles</source>
        <translation>{0}° kommt nach {1}°; führen Sie die Stellungen in der Reihenfolge ihrer Winkel auf</translation>
    </message>
    <message>
        <source>there are {0} photographs for {1} exposures; expected one for each</source>
        <translation>es gibt {0} Fotos für {1} Belichtungen; erwartet wurde eines für jede</translation>
    </message>
    <message>
        <source>is not a folder; expected a folder of photographs with a session.json</source>
        <translation>ist kein Ordner; erwartet wurde ein Ordner mit Fotos und einer session.json</translation>
    </message>
    <message>
        <source>holds no {0}; {1} writes one to fill in</source>
        <translation>enthält keine {0}; {1} schreibt eine zum Ausfüllen</translation>
    </message>
    <message>
        <source>the message</source>
        <translation>die Nachricht</translation>
    </message>
    <message>
        <source>camera.distance_m, camera.height_m: level distance to the turntable&apos;s axis, height above the sphere&apos;s centre</source>
        <translation>camera.distance_m, camera.height_m: waagerechter Abstand zur Achse des Drehtellers, Höhe über dem Kugelmittelpunkt</translation>
    </message>
    <message>
        <source>sphere.radius_m: measure it with a caliper</source>
        <translation>sphere.radius_m: Messen Sie ihn mit einem Messschieber</translation>
    </message>
    <message>
        <source>light.distance_m, light.height_m: of the lamp, as of the camera</source>
        <translation>light.distance_m, light.height_m: der Lampe, wie bei der Kamera</translation>
    </message>
    <message>
        <source>camera.response: unknown (recovered from the exposures), linear or srgb</source>
        <translation>camera.response: unknown (aus den Belichtungen ermittelt), linear oder srgb</translation>
    </message>
    <message>
        <source>is there already, and is not overwritten</source>
        <translation>gibt es schon und wird nicht überschrieben</translation>
    </message>
    <message>
        <source>no session can be made of it: {0}: {1}</source>
        <translation>daraus lässt sich keine Sitzung machen: {0}: {1}</translation>
    </message>
    <message>
        <source>light.irradiance_rgb or a white reference: without them the table has no absolute scale</source>
        <translation>light.irradiance_rgb oder eine Weißreferenz: ohne sie hat die Tabelle keinen absoluten Maßstab</translation>
    </message>
    <message>
        <source>{0}each position has one for each exposure</source>
        <translation>{0}jede Stellung hat eines für jede Belichtung</translation>
    </message>
    <message>
        <source>camera.board: state the board&apos;s inner corners (columns, rows) and the side of a square</source>
        <translation>camera.board: Geben Sie die inneren Ecken der Tafel (Spalten, Zeilen) und die Seite eines Quadrats an</translation>
    </message>
    <message>
        <source>{0}: {1} photographs for {2} exposures are left out</source>
        <translation>{0}: {1} Fotos für {2} Belichtungen sind ausgelassen</translation>
    </message>
    <message>
        <source>{0}; expected one for each</source>
        <translation>{0}; erwartet wurde eines für jede</translation>
    </message>
    <message>
        <source>a region that shows nothing but the white</source>
        <translation>ein Bereich, der nichts als das Weiß zeigt</translation>
    </message>
    <message>
        <source>white: state its reflectance, the lamp&apos;s angle, and {0}</source>
        <translation>white: Geben Sie seinen Reflexionsgrad, den Winkel der Lampe und {0} an</translation>
    </message>
    <message>
        <source>flat_field: state its exposure time</source>
        <translation>flat_field: Geben Sie seine Belichtungszeit an</translation>
    </message>
    <message>
        <source>put those of each position of the lamp into a folder of their own</source>
        <translation>legen Sie die jeder Stellung der Lampe in einen eigenen Ordner</translation>
    </message>
    <message>
        <source>has its photographs beside each other; {0}</source>
        <translation>hat seine Fotos nebeneinander; {0}</translation>
    </message>
    <message>
        <source>exposures_s: taken from the EXIF of the first position</source>
        <translation>exposures_s: aus den EXIF-Daten der ersten Stellung übernommen</translation>
    </message>
    <message>
        <source>exposures_s: the files state no times, or the same twice; these are those of a typical rig</source>
        <translation>exposures_s: Die Dateien geben keine Zeiten an, oder zweimal dieselbe; dies sind die eines üblichen Aufbaus</translation>
    </message>
    <message>
        <source>positions: the numbers in the names of the folders are taken for degrees</source>
        <translation>positions: Die Zahlen in den Namen der Ordner gelten als Grad</translation>
    </message>
    <message>
        <source>positions: the angles are even steps from 0° to 180°; correct them</source>
        <translation>positions: Die Winkel sind gleiche Schritte von 0° bis 180°; berichtigen Sie sie</translation>
    </message>
    <message>
        <source>camera.bit_depth: the highest code of {0} is {1}</source>
        <translation>camera.bit_depth: Der höchste Code von {0} ist {1}</translation>
    </message>
    <message>
        <source>{0}, so {1} bits are taken</source>
        <translation>{0}, daher gelten {1} Bit</translation>
    </message>
    <message>
        <source>the folder holds no photographs yet; the names are those that the template proposes</source>
        <translation>der Ordner enthält noch keine Fotos; die Namen sind die, die die Vorlage vorschlägt</translation>
    </message>
    <message>
        <source>From the axis, level</source>
        <translation>Von der Achse, waagerecht</translation>
    </message>
    <message>
        <source>Above the sphere&apos;s centre</source>
        <translation>Über dem Kugelmittelpunkt</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Of the camera&apos;s axis above the horizon</source>
        <translation>Der Kameraachse über der Waagerechten</translation>
    </message>
    <message>
        <source>Of the camera</source>
        <translation>Der Kamera</translation>
    </message>
    <message>
        <source>Principal point</source>
        <translation>Hauptpunkt</translation>
    </message>
    <message>
        <source>From the middle of pixel 0, 0</source>
        <translation>Von der Mitte des Pixels 0, 0</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzeichnung</translation>
    </message>
    <message>
        <source>A coefficient of OpenCV&apos;s model</source>
        <translation>Ein Koeffizient des Modells von OpenCV</translation>
    </message>
    <message>
        <source>Colour matrix</source>
        <translation>Farbmatrix</translation>
    </message>
    <message>
        <source>Camera channels to linear Rec. 2020</source>
        <translation>Kanäle der Kamera nach linearem Rec. 2020</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Side of a square of the board</source>
        <translation>Seite eines Quadrats der Tafel</translation>
    </message>
    <message>
        <source>Of the painted sphere</source>
        <translation>Der lackierten Kugel</translation>
    </message>
    <message>
        <source>In the world of the rig</source>
        <translation>In der Welt des Aufbaus</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>A vector of any length</source>
        <translation>Ein Vektor beliebiger Länge</translation>
    </message>
    <message>
        <source>Added to every stated angle</source>
        <translation>Wird zu jedem angegebenen Winkel addiert</translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation>Bestrahlungsstärke</translation>
    </message>
    <message>
        <source>At the sphere&apos;s centre, facing the lamp</source>
        <translation>Am Kugelmittelpunkt, der Lampe zugewandt</translation>
    </message>
    <message>
        <source>Of what hides the sphere from the camera</source>
        <translation>Dessen, was der Kamera die Kugel verdeckt</translation>
    </message>
    <message>
        <source>Angle off the axis</source>
        <translation>Winkel zur Achse</translation>
    </message>
    <message>
        <source>Of the lamp</source>
        <translation>Der Lampe</translation>
    </message>
    <message>
        <source>Relative intensity</source>
        <translation>Relative Stärke</translation>
    </message>
    <message>
        <source>At this angle</source>
        <translation>Bei diesem Winkel</translation>
    </message>
    <message>
        <source>Of the white reference, π f_r</source>
        <translation>Der Weißreferenz, π f_r</translation>
    </message>
    <message>
        <source>Of the lamp, 0 in front of the camera</source>
        <translation>Der Lampe, 0 vor der Kamera</translation>
    </message>
    <message>
        <source>Exposure time</source>
        <translation>Belichtungszeit</translation>
    </message>
    <message>
        <source>Of a photograph</source>
        <translation>Eines Fotos</translation>
    </message>
    <message>
        <source>expected a whole number, not {0}</source>
        <translation>erwartet wurde eine ganze Zahl, nicht {0}</translation>
    </message>
    <message>
        <source>{0} is outside the range {1} to {2}</source>
        <translation>{0} liegt außerhalb des Bereichs {1} bis {2}</translation>
    </message>
    <message>
        <source>expected a list of times, not {0}</source>
        <translation>erwartet wurde eine Liste von Zeiten, nicht {0}</translation>
    </message>
    <message>
        <source>expected at most {0}, found {1}</source>
        <translation>erwartet wurden höchstens {0}, gefunden {1}</translation>
    </message>
    <message>
        <source>{0} s comes after {1} s; {2}</source>
        <translation>{0} s kommt nach {1} s; {2}</translation>
    </message>
    <message>
        <source>expected a list of names of files, not {0}</source>
        <translation>erwartet wurde eine Liste von Dateinamen, nicht {0}</translation>
    </message>
    <message>
        <source>expected {0} to {1} files, found {2}</source>
        <translation>erwartet wurden {0} bis {1} Dateien, gefunden {2}</translation>
    </message>
    <message>
        <source>{0}: write folders with / between them, relative to session.json</source>
        <translation>{0}: Schreiben Sie Ordner mit / dazwischen, relativ zu session.json</translation>
    </message>
    <message>
        <source>{0} lies outside the folder of the session</source>
        <translation>{0} liegt außerhalb des Ordners der Sitzung</translation>
    </message>
    <message>
        <source>{0} is the file of {1} already</source>
        <translation>{0} ist bereits die Datei von {1}</translation>
    </message>
    <message>
        <source>photograph {0} of {1}</source>
        <translation>Foto {0} von {1}</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>is not empty; name a new folder for the photographs and {0}</source>
        <translation>ist nicht leer; nennen Sie einen neuen Ordner für die Fotos und {0}</translation>
    </message>
    <message>
        <source>cannot be written ({0})</source>
        <translation>lässt sich nicht schreiben ({0})</translation>
    </message>
    <message>
        <source>Shortest exposure</source>
        <translation>Kürzeste Belichtung</translation>
    </message>
    <message>
        <source>Longest exposure</source>
        <translation>Längste Belichtung</translation>
    </message>
    <message>
        <source>Lamp offset</source>
        <translation>Versatz der Lampe</translation>
    </message>
    <message>
        <source>Of the turntable&apos;s zero</source>
        <translation>Des Nullpunkts des Drehtellers</translation>
    </message>
    <message>
        <source>Lamp height offset</source>
        <translation>Versatz der Lampenhöhe</translation>
    </message>
    <message>
        <source>Above what is stated</source>
        <translation>Über dem angegebenen Wert</translation>
    </message>
    <message>
        <source>From the axis</source>
        <translation>Von der Achse</translation>
    </message>
    <message>
        <source>The camera is tilted to the sphere</source>
        <translation>Die Kamera ist zur Kugel geneigt</translation>
    </message>
    <message>
        <source>Of the sphere</source>
        <translation>Der Kugel</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Diameter of the sphere over the picture&apos;s shorter side</source>
        <translation>Durchmesser der Kugel durch die kürzere Seite des Bildes</translation>
    </message>
    <message>
        <source>At the corner, of the distance to it</source>
        <translation>In der Ecke, bezogen auf den Abstand dorthin</translation>
    </message>
    <message>
        <source>Vignetting</source>
        <translation>Vignettierung</translation>
    </message>
    <message>
        <source>Loss of light at the corner</source>
        <translation>Lichtverlust in der Ecke</translation>
    </message>
    <message>
        <source>Full well</source>
        <translation>Sättigungsladung</translation>
    </message>
    <message>
        <source>Electrons at full scale</source>
        <translation>Elektronen bei Vollausschlag</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Quadratisches Mittel</translation>
    </message>
    <message>
        <source>Dark current</source>
        <translation>Dunkelstrom</translation>
    </message>
    <message>
        <source>Mean of all pixels</source>
        <translation>Mittel aller Pixel</translation>
    </message>
    <message>
        <source>Gain spread</source>
        <translation>Streuung der Verstärkung</translation>
    </message>
    <message>
        <source>From pixel to pixel, root mean square</source>
        <translation>Von Pixel zu Pixel, quadratisches Mittel</translation>
    </message>
    <message>
        <source>{0} is outside the range 16 to 16384</source>
        <translation>{0} liegt außerhalb des Bereichs 16 bis 16384</translation>
    </message>
    <message>
        <source>{0} is no whole number from {1} to {2}</source>
        <translation>{0} ist keine ganze Zahl von {1} bis {2}</translation>
    </message>
    <message>
        <source>must be longer than the shortest exposure</source>
        <translation>muss länger als die kürzeste Belichtung sein</translation>
    </message>
    <message>
        <source>position {0} is not one of the later ones</source>
        <translation>Stellung {0} ist keine der späteren</translation>
    </message>
    <message>
        <source>{0} pixels, the picture&apos;s size, are the most</source>
        <translation>{0} Pixel, die Größe des Bildes, sind das Höchste</translation>
    </message>
    <message>
        <source>{0}°; expected above 0° and below 90°</source>
        <translation>{0}°; erwartet wurde über 0° und unter 90°</translation>
    </message>
    <message>
        <source>{0} pixels; the photographs have {1}</source>
        <translation>{0} Pixel; die Fotos haben {1}</translation>
    </message>
    <message>
        <source>{0} rows and columns; {1} wanted</source>
        <translation>{0} Zeilen und Spalten; verlangt sind {1}</translation>
    </message>
    <message>
        <source>{0} of a photograph or those of the box wanted</source>
        <translation>{0} eines Fotos oder die des gewünschten Kastens</translation>
    </message>
    <message>
        <source>{0} rows and {1} columns; {2}</source>
        <translation>{0} Zeilen und {1} Spalten; {2}</translation>
    </message>
    <message>
        <source>expected a finite matrix of 3 × 3 numbers</source>
        <translation>erwartet wurde eine endliche Matrix von 3 × 3 Zahlen</translation>
    </message>
    <message>
        <source>no bin has a reading; nothing was measured</source>
        <translation>kein Feld hat einen Messwert; nichts wurde gemessen</translation>
    </message>
    <message>
        <source>gloss is measured at 20, 60 or 85°, not {0}°</source>
        <translation>Glanz wird bei 20, 60 oder 85° gemessen, nicht bei {0}°</translation>
    </message>
    <message>
        <source>With {0} GU at 20°, a coat over this base (which gives {1} GU itself at 60°) reads from {2} to {3} GU at 60°; {4} GU cannot be reached.</source>
        <translation>Bei {0} GU bei 20° liest man an einem Klarlack über dieser Basis (die selbst {1} GU bei 60° ergibt) {2} bis {3} GU bei 60° ab; {4} GU sind nicht erreichbar.</translation>
    </message>
    <message>
        <source>A gloss of {0} GU at 20° cannot be reached: over this base, which gives {1} GU itself, a clearcoat reads from {2} to {3} GU.</source>
        <translation>Ein Glanz von {0} GU bei 20° ist nicht erreichbar: Über dieser Basis, die selbst {1} GU ergibt, liest man an einem Klarlack {2} bis {3} GU ab.</translation>
    </message>
    <message>
        <source>expected one of {0}, not {1}</source>
        <translation>erwartet wurde eines von {0}, nicht {1}</translation>
    </message>
    <message>
        <source>{0} of {1} colours{2} lie outside the working space (Rec. 2020); their negative channel became 0, a change of at most ΔE00 {3}.</source>
        <translation>{0} von {1} Farben{2} liegen außerhalb des Arbeitsfarbraums (Rec. 2020); ihr negativer Kanal wurde 0, eine Änderung von höchstens ΔE00 {3}.</translation>
    </message>
    <message>
        <source>{0} {1} colours are shown without a profile, so only roughly; the numbers are kept as they are.</source>
        <translation>{0} {1}-Farben werden ohne Profil gezeigt, also nur ungefähr; die Zahlen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>{0} {1} colour is shown without a profile, so only roughly; the numbers are kept as they are.</source>
        <translation>{0} {1}-Farbe wird ohne Profil gezeigt, also nur ungefähr; die Zahlen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>s are</source>
        <translation>s sind</translation>
    </message>
    <message>
        <source>The colour space {0} is not known here; its colours are shown as sRGB.</source>
        <translation>Der Farbraum {0} ist hier nicht bekannt; seine Farben werden als sRGB gezeigt.</translation>
    </message>
    <message>
        <source>expected a matrix of 3 by 3 finite numbers</source>
        <translation>erwartet wurde eine Matrix von 3 mal 3 endlichen Zahlen</translation>
    </message>
    <message>
        <source>expected a table of n by 3, not {0}</source>
        <translation>erwartet wurde eine Tabelle von n mal 3, nicht {0}</translation>
    </message>
    <message>
        <source>expected the 2° or the 10° observer, not {0}</source>
        <translation>erwartet wurde der 2°- oder der 10°-Beobachter, nicht {0}</translation>
    </message>
    <message>
        <source>expected a list of wavelengths, not shape {0}</source>
        <translation>erwartet wurde eine Liste von Wellenlängen, nicht Form {0}</translation>
    </message>
    <message>
        <source>expected wavelengths from {0} to {1} nm</source>
        <translation>erwartet wurden Wellenlängen von {0} bis {1} nm</translation>
    </message>
    <message>
        <source>the wavelengths must rise</source>
        <translation>die Wellenlängen müssen steigen</translation>
    </message>
    <message>
        <source>expected {0} values along the last axis, not shape {1}</source>
        <translation>erwartet wurden {0} Werte entlang der letzten Achse, nicht Form {1}</translation>
    </message>
    <message>
        <source>expected a positive luminance in cd/m²</source>
        <translation>erwartet wurde eine Leuchtdichte über 0 in cd/m²</translation>
    </message>
    <message>
        <source>expected a relative luminance above 0 and to 100</source>
        <translation>erwartet wurde eine relative Leuchtdichte über 0 und bis 100</translation>
    </message>
    <message>
        <source>expected one of {0} or cmc:l:c, not {1}</source>
        <translation>erwartet wurde eines von {0} oder cmc:l:c, nicht {1}</translation>
    </message>
    <message>
        <source>expected a number from 0, not {0}</source>
        <translation>erwartet wurde eine Zahl ab 0, nicht {0}</translation>
    </message>
    <message>
        <source>tolerance of the {0}</source>
        <translation>Toleranz von {0}</translation>
    </message>
    <message>
        <source>tolerance at {0}°</source>
        <translation>Toleranz bei {0}°</translation>
    </message>
    <message>
        <source>expected {0} L*a*b* values of each, not shapes {1} and {2}</source>
        <translation>erwartet wurden je {0} L*a*b*-Werte, nicht die Formen {1} und {2}</translation>
    </message>
    <message>
        <source>a flop needs a reading before the face and one beyond it</source>
        <translation>ein Flop braucht einen Messwert vor der Aufsicht und einen dahinter</translation>
    </message>
    <message>
        <source>expected a number of at least 0, not {0}</source>
        <translation>erwartet wurde eine Zahl von mindestens 0, nicht {0}</translation>
    </message>
    <message>
        <source>the flop index needs readings at 15, 45 and 110°</source>
        <translation>der Flop-Index braucht Messwerte bei 15, 45 und 110°</translation>
    </message>
    <message>
        <source>L* at 45° is 0: there is no flop index</source>
        <translation>L* bei 45° ist 0: Es gibt keinen Flop-Index</translation>
    </message>
    <message>
        <source>a reading is grey: there is no hue to travel from or to</source>
        <translation>ein Messwert ist grau: Es gibt keinen Buntton, von dem oder zu dem der Weg führt</translation>
    </message>
    <message>
        <source>lighter at 110° than at 15°: the flop index does not describe this paint</source>
        <translation>bei 110° heller als bei 15°: Der Flop-Index beschreibt diesen Lack nicht</translation>
    </message>
    <message>
        <source>L* at 45° is below {0}: the flop index is uncertain</source>
        <translation>L* bei 45° liegt unter {0}: Der Flop-Index ist unsicher</translation>
    </message>
    <message>
        <source>travel needs readings at 15° and at 110°</source>
        <translation>der Weg braucht Messwerte bei 15° und bei 110°</translation>
    </message>
    <message>
        <source>a reading has a chroma below {0}: the hue travel is uncertain</source>
        <translation>ein Messwert hat eine Buntheit unter {0}: Der Weg des Bunttons ist unsicher</translation>
    </message>
    <message>
        <source>expected a finite angle in degrees</source>
        <translation>erwartet wurde ein endlicher Winkel in Grad</translation>
    </message>
    <message>
        <source>expected a polar angle from 0 to below 90°, not {0}°</source>
        <translation>erwartet wurde ein Polarwinkel von 0 bis unter 90°, nicht {0}°</translation>
    </message>
    <message>
        <source>with the light at {0}°, {1}° would look from below the surface (polar angle {2}°)</source>
        <translation>mit dem Licht bei {0}° sähe {1}° von unterhalb der Oberfläche (Polarwinkel {2}°)</translation>
    </message>
    <message>
        <source>{0}, light {1}°</source>
        <translation>{0}, Licht {1}°</translation>
    </message>
    <message>
        <source>expected 1 to {0} geometries</source>
        <translation>erwartet wurden 1 bis {0} Geometrien</translation>
    </message>
    <message>
        <source>a geometry is named twice</source>
        <translation>eine Geometrie ist zweimal genannt</translation>
    </message>
    <message>
        <source>six angles, one beyond the mirror direction</source>
        <translation>sechs Winkel, einer jenseits der Spiegelrichtung</translation>
    </message>
    <message>
        <source>interference pigments, ASTM E2539</source>
        <translation>Interferenzpigmente, ASTM E2539</translation>
    </message>
    <message>
        <source>{0} is neither a named set ({1}) nor angles like 45:15,45,110;15:15</source>
        <translation>{0} ist weder ein benannter Satz ({1}) noch Winkel wie 45:15,45,110;15:15</translation>
    </message>
    <message>
        <source>the paint&apos;s own angles</source>
        <translation>die eigenen Winkel des Lacks</translation>
    </message>
    <message>
        <source>shape {0}, not (h, w, 3)</source>
        <translation>Form {0}, nicht (h, w, 3)</translation>
    </message>
    <message>
        <source>expected an angle of 0 to {0}°, not {1}</source>
        <translation>erwartet wurde ein Winkel von 0 bis {0}°, nicht {1}°</translation>
    </message>
    <message>
        <source>as measured under D65</source>
        <translation>wie unter D65 gemessen</translation>
    </message>
    <message>
        <source>adapted from D65; the spectrum is not known, so metamerism is not shown</source>
        <translation>von D65 umgerechnet; das Spektrum ist nicht bekannt, Metamerie wird daher nicht gezeigt</translation>
    </message>
    <message>
        <source>recomputed from the spectrum</source>
        <translation>aus dem Spektrum neu berechnet</translation>
    </message>
    <message>
        <source>it has no light in one of X, Y, Z, so it cannot be brought to match</source>
        <translation>es hat kein Licht in einem von X, Y, Z und lässt sich daher nicht angleichen</translation>
    </message>
    <message>
        <source>colour temperature</source>
        <translation>Farbtemperatur</translation>
    </message>
    <message>
        <source>{0} K is outside the range 1,000 to 25,000 K</source>
        <translation>{0} K liegt außerhalb des Bereichs 1.000 bis 25.000 K</translation>
    </message>
    <message>
        <source>BRDF Suite texture 1</source>
        <translation>BRDF Suite texture 1</translation>
    </message>
    <message>
        <source>the evaluation of photographs</source>
        <translation>die Auswertung von Fotos</translation>
    </message>
    <message>
        <source>it is not a plain file</source>
        <translation>sie ist keine einfache Datei</translation>
    </message>
    <message>
        <source>Diffuse reflectance, linear Rec. 2020</source>
        <translation>Diffuse Reflexion, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Spiegelnd</translation>
    </message>
    <message>
        <source>Weight of the lobe, linear Rec. 2020</source>
        <translation>Gewicht der Keule, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Root-mean-square slope of the facets</source>
        <translation>Quadratisches Mittel der Facettenneigung</translation>
    </message>
    <message>
        <source>Fresnel reflectance along the normal</source>
        <translation>Fresnel-Reflexionsgrad entlang der Normalen</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Brechzahl</translation>
    </message>
    <message>
        <source>Index of refraction of the clearcoat</source>
        <translation>Brechzahl des Klarlacks</translation>
    </message>
    <message>
        <source>Beckmann α of the clearcoat</source>
        <translation>Beckmann-α des Klarlacks</translation>
    </message>
    <message>
        <source>a clearcoat</source>
        <translation>einen Klarlack</translation>
    </message>
    <message>
        <source>expected three numbers red, green, blue, not {0}</source>
        <translation>erwartet wurden drei Zahlen Rot, Grün, Blau, nicht {0}</translation>
    </message>
    <message>
        <source>its textures cannot be written ({0})</source>
        <translation>seine Texturen lassen sich nicht schreiben ({0})</translation>
    </message>
    <message>
        <source>lacks the map {0} that the paint reads</source>
        <translation>ihm fehlt die Karte {0}, die der Lack liest</translation>
    </message>
    <message>
        <source>part {0}</source>
        <translation>Teil {0}</translation>
    </message>
    <message>
        <source>is {0} × {1} texels, which {2} does not read</source>
        <translation>hat {0} × {1} Texel, die {2} nicht liest</translation>
    </message>
    <message>
        <source>holds a number that is no factor</source>
        <translation>enthält eine Zahl, die kein Faktor ist</translation>
    </message>
    <message>
        <source>holds no maps ({0})</source>
        <translation>enthält keine Karten ({0})</translation>
    </message>
    <message>
        <source>holds no maps that can be decoded</source>
        <translation>enthält keine Karten, die sich entschlüsseln lassen</translation>
    </message>
    <message>
        <source>the maps in {0} are not those that the paint was saved with; factor it again, or bring them back</source>
        <translation>die Karten in {0} sind nicht die, mit denen der Lack gespeichert wurde; faktorisieren Sie ihn neu, oder bringen Sie sie zurück</translation>
    </message>
    <message>
        <source>1/sr</source>
        <translation>1/sr</translation>
    </message>
    <message>
        <source>What the product of the maps is multiplied by</source>
        <translation>Womit das Produkt der Karten multipliziert wird</translation>
    </message>
    <message>
        <source>expected 64 hexadecimal digits, not {0}</source>
        <translation>erwartet wurden 64 hexadezimale Ziffern, nicht {0}</translation>
    </message>
    <message>
        <source>expected a texture file, not {0}</source>
        <translation>erwartet wurde eine Texturdatei, nicht {0}</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Share of the ink; 1 is full</source>
        <translation>Anteil der Druckfarbe; 1 ist voll</translation>
    </message>
    <message>
        <source>Angle of the hue</source>
        <translation>Winkel des Bunttons</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>0 is grey</source>
        <translation>0 ist grau</translation>
    </message>
    <message>
        <source>Encoded value; 1 is the most of a display</source>
        <translation>Kodierter Wert; 1 ist das Höchste eines Bildschirms</translation>
    </message>
    <message>
        <source>Encoded value; 0 is black, 1 is white</source>
        <translation>Kodierter Wert; 0 ist schwarz, 1 ist weiß</translation>
    </message>
    <message>
        <source>Largest of R, G and B</source>
        <translation>Größter von R, G und B</translation>
    </message>
    <message>
        <source>Mean of the largest and the least of R, G and B</source>
        <translation>Mittel aus dem größten und dem kleinsten von R, G und B</translation>
    </message>
    <message>
        <source>Green to red</source>
        <translation>Grün nach Rot</translation>
    </message>
    <message>
        <source>Blue to yellow</source>
        <translation>Blau nach Gelb</translation>
    </message>
    <message>
        <source>The white&apos;s Y is 100</source>
        <translation>Y des Weiß ist 100</translation>
    </message>
    <message>
        <source>1 is a perfect diffuser</source>
        <translation>1 ist ein vollkommen streuender Körper</translation>
    </message>
    <message>
        <source>nm</source>
        <translation>nm</translation>
    </message>
    <message>
        <source>Of a band of the spectrum</source>
        <translation>Eines Bandes des Spektrums</translation>
    </message>
    <message>
        <source>expected 2, 10 or 0, not {0}</source>
        <translation>erwartet wurde 2, 10 oder 0, nicht {0}</translation>
    </message>
    <message>
        <source>expected a list of at most {0} colours</source>
        <translation>erwartet wurde eine Liste von höchstens {0} Farben</translation>
    </message>
    <message>
        <source>expected a colour without others of its own</source>
        <translation>erwartet wurde eine Farbe ohne weitere eigene</translation>
    </message>
    <message>
        <source>expected a list of numbers, not {0}</source>
        <translation>erwartet wurde eine Liste von Zahlen, nicht {0}</translation>
    </message>
    <message>
        <source>a colour in {0} has none</source>
        <translation>eine Farbe in {0} hat keine</translation>
    </message>
    <message>
        <source>{0} has {1} numbers, not {2}</source>
        <translation>{0} hat {1} Zahlen, nicht {2}</translation>
    </message>
    <message>
        <source>expected 2 to {0} numbers, as many as wavelengths, not {1}</source>
        <translation>erwartet wurden 2 bis {0} Zahlen, so viele wie Wellenlängen, nicht {1}</translation>
    </message>
    <message>
        <source>wavelengths must rise</source>
        <translation>Wellenlängen müssen steigen</translation>
    </message>
    <message>
        <source>Illumination</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Polar angle of the instrument&apos;s light</source>
        <translation>Polarwinkel des Lichts im Messgerät</translation>
    </message>
    <message>
        <source>From the mirror direction to the view, past the normal</source>
        <translation>Von der Spiegelrichtung zum Blick, an der Normalen vorbei</translation>
    </message>
    <message>
        <source>Reading at 20°, coat and base together</source>
        <translation>Messwert bei 20°, Klarlack und Basis zusammen</translation>
    </message>
    <message>
        <source>Reading at 60°, coat and base together</source>
        <translation>Messwert bei 60°, Klarlack und Basis zusammen</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>Root mean square height of the coat&apos;s waviness</source>
        <translation>Quadratisches Mittel der Höhe der Welligkeit des Klarlacks</translation>
    </message>
    <message>
        <source>Peel wavelength</source>
        <translation>Wellenlänge der Orangenhaut</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Flake density</source>
        <translation>Flake-Dichte</translation>
    </message>
    <message>
        <source>1/mm²</source>
        <translation>1/mm²</translation>
    </message>
    <message>
        <source>Flakes that can be seen per area</source>
        <translation>Sichtbare Flakes je Fläche</translation>
    </message>
    <message>
        <source>Flake size</source>
        <translation>Flake-Größe</translation>
    </message>
    <message>
        <source>Mean diameter of a flake</source>
        <translation>Mittlerer Durchmesser eines Flakes</translation>
    </message>
    <message>
        <source>Flake roughness</source>
        <translation>Flake-Rauheit</translation>
    </message>
    <message>
        <source>Spread of the flake tilts</source>
        <translation>Streuung der Flake-Neigungen</translation>
    </message>
    <message>
        <source>Flake colour spread</source>
        <translation>Farbstreuung der Flakes</translation>
    </message>
    <message>
        <source>0: all flakes of one colour; 1: every hue</source>
        <translation>0: alle Flakes in einer Farbe; 1: jeder Buntton</translation>
    </message>
    <message>
        <source>Sparkle 15°</source>
        <translation>Glitzern 15°</translation>
    </message>
    <message>
        <source>Grade in light from 15° to aim at</source>
        <translation>Angestrebter Grad im Licht aus 15°</translation>
    </message>
    <message>
        <source>Sparkle 45°</source>
        <translation>Glitzern 45°</translation>
    </message>
    <message>
        <source>Grade in light from 45° to aim at</source>
        <translation>Angestrebter Grad im Licht aus 45°</translation>
    </message>
    <message>
        <source>Sparkle 75°</source>
        <translation>Glitzern 75°</translation>
    </message>
    <message>
        <source>Grade in light from 75° to aim at</source>
        <translation>Angestrebter Grad im Licht aus 75°</translation>
    </message>
    <message>
        <source>Graininess</source>
        <translation>Körnigkeit</translation>
    </message>
    <message>
        <source>In diffuse light, to aim at</source>
        <translation>In diffusem Licht, angestrebt</translation>
    </message>
    <message>
        <source>Scales the base in the mirror direction; not measured</source>
        <translation>Skaliert die Basis in der Spiegelrichtung; nicht gemessen</translation>
    </message>
    <message>
        <source>expected three numbers L*, a*, b*, not {0}</source>
        <translation>erwartet wurden drei Zahlen L*, a*, b*, nicht {0}</translation>
    </message>
    <message>
        <source>waves of {0} µm and {1} mm would be steeper than {2}°; at this wavelength at most {3} µm</source>
        <translation>Wellen von {0} µm und {1} mm wären steiler als {2}°; bei dieser Wellenlänge höchstens {3} µm</translation>
    </message>
    <message>
        <source>expected gloss readings, not {0}</source>
        <translation>erwartet wurden Glanzwerte, nicht {0}</translation>
    </message>
    <message>
        <source>orange peel</source>
        <translation>Orangenhaut</translation>
    </message>
    <message>
        <source>targets of texture</source>
        <translation>Zielwerte der Textur</translation>
    </message>
    <message>
        <source>only the 10° observer is known, not {0}</source>
        <translation>nur der 10°-Beobachter ist bekannt, nicht {0}</translation>
    </message>
    <message>
        <source>nothing is measured with the light at {0}°; there are {1}°</source>
        <translation>mit dem Licht bei {0}° ist nichts gemessen; es gibt {1}°</translation>
    </message>
    <message>
        <source>with the light at {0}°</source>
        <translation>mit dem Licht bei {0}°</translation>
    </message>
    <message>
        <source>{0}° is not measured{1}; there are {2}°</source>
        <translation>{0}° ist nicht gemessen{1}; es gibt {2}°</translation>
    </message>
    <message>
        <source>expected a list, not {0}</source>
        <translation>erwartet wurde eine Liste, nicht {0}</translation>
    </message>
    <message>
        <source>expected 3 to {0} measurements, found {1}</source>
        <translation>erwartet wurden 3 bis {0} Messwerte, gefunden {1}</translation>
    </message>
    <message>
        <source>expected a measurement, not {0}</source>
        <translation>erwartet wurde ein Messwert, nicht {0}</translation>
    </message>
    <message>
        <source>has the same angles as measurements[{0}]</source>
        <translation>hat dieselben Winkel wie measurements[{0}]</translation>
    </message>
    <message>
        <source>expected a paint or a flat colour, not {0}</source>
        <translation>erwartet wurde ein Lack oder eine einzelne Farbe, nicht {0}</translation>
    </message>
    <message>
        <source>the tag {0} is there twice</source>
        <translation>das Schlagwort {0} kommt zweimal vor</translation>
    </message>
    <message>
        <source>a group has a name</source>
        <translation>eine Gruppe hat einen Namen</translation>
    </message>
    <message>
        <source>expected a whole number from 0 to 10,000, not {0}</source>
        <translation>erwartet wurde eine ganze Zahl von 0 bis 10.000, nicht {0}</translation>
    </message>
    <message>
        <source>the id {0} is there twice</source>
        <translation>die Kennung {0} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the group {0} is there twice</source>
        <translation>die Gruppe {0} kommt zweimal vor</translation>
    </message>
    <message>
        <source>{0} are more than the {1} allowed</source>
        <translation>{0} sind mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>expected a name and a text</source>
        <translation>erwartet wurden ein Name und ein Text</translation>
    </message>
    <message>
        <source>expected #rrggbb in lower case, not {0}</source>
        <translation>erwartet wurde #rrggbb in Kleinbuchstaben, nicht {0}</translation>
    </message>
    <message>
        <source>expected a date as in 2024-05-31, not {0}</source>
        <translation>erwartet wurde ein Datum wie 2024-05-31, nicht {0}</translation>
    </message>
    <message>
        <source>an entry is named twice</source>
        <translation>ein Eintrag ist zweimal genannt</translation>
    </message>
    <message>
        <source>the group {0} is there already</source>
        <translation>die Gruppe {0} gibt es schon</translation>
    </message>
    <message>
        <source>a group cannot go into itself</source>
        <translation>eine Gruppe kann nicht in sich selbst gelegt werden</translation>
    </message>
    <message>
        <source>no entry has the id {0}</source>
        <translation>kein Eintrag hat die Kennung {0}</translation>
    </message>
    <message>
        <source>there is no group {0}</source>
        <translation>es gibt keine Gruppe {0}</translation>
    </message>
    <message>
        <source>expected one of &quot;paint&quot; and &quot;flat&quot;</source>
        <translation>erwartet wurde „paint“ oder „flat“</translation>
    </message>
    <message>
        <source>expected a number, not {0}</source>
        <translation>erwartet wurde eine Zahl, nicht {0}</translation>
    </message>
    <message>
        <source>expected a finite number, not {0}</source>
        <translation>erwartet wurde eine endliche Zahl, nicht {0}</translation>
    </message>
    <message>
        <source>{0}{1} is outside the range {2} to {3}{4}</source>
        <translation>{0}{1} liegt außerhalb des Bereichs {2} bis {3}{4}</translation>
    </message>
    <message>
        <source>expected a list of {0} numbers, not {1}</source>
        <translation>erwartet wurde eine Liste von {0} Zahlen, nicht {1}</translation>
    </message>
    <message>
        <source>expected true or false, not {0}</source>
        <translation>erwartet wurde wahr oder falsch, nicht {0}</translation>
    </message>
    <message>
        <source>expected {0} or nothing, not {1}</source>
        <translation>erwartet wurde {0} oder nichts, nicht {1}</translation>
    </message>
    <message>
        <source>expected a {0}, not {1}</source>
        <translation>erwartet wurde {0}, nicht {1}</translation>
    </message>
    <message>
        <source>the text {0}</source>
        <translation>der Text {0}</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list of {0}</source>
        <translation>eine Liste von {0}</translation>
    </message>
    <message>
        <source>expected a text, not {0}</source>
        <translation>erwartet wurde ein Text, nicht {0}</translation>
    </message>
    <message>
        <source>{0} characters are more than the {1} allowed</source>
        <translation>{0} Zeichen sind mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>the text is empty</source>
        <translation>der Text ist leer</translation>
    </message>
    <message>
        <source>the character {0} is not allowed in this text</source>
        <translation>das Zeichen {0} ist in diesem Text nicht erlaubt</translation>
    </message>
    <message>
        <source>expected a view, not {0}</source>
        <translation>erwartet wurde eine Ansicht, nicht {0}</translation>
    </message>
    <message>
        <source>expected a whole number from 1 to {0}, not {1}</source>
        <translation>erwartet wurde eine ganze Zahl von 1 bis {0}, nicht {1}</translation>
    </message>
    <message>
        <source>expected a paint, not {0}</source>
        <translation>erwartet wurde ein Lack, nicht {0}</translation>
    </message>
    <message>
        <source>expected an absolute path, not {0}</source>
        <translation>erwartet wurde ein absoluter Pfad, nicht {0}</translation>
    </message>
    <message>
        <source>{0} is the name of another view</source>
        <translation>{0} ist der Name einer anderen Ansicht</translation>
    </message>
    <message>
        <source>no view of the project is called {0}</source>
        <translation>keine Ansicht des Projekts heißt {0}</translation>
    </message>
    <message>
        <source>is a folder without {0}</source>
        <translation>ist ein Ordner ohne {0}</translation>
    </message>
    <message>
        <source>{0} is no collected file of the project</source>
        <translation>{0} ist keine eingesammelte Datei des Projekts</translation>
    </message>
    <message>
        <source>is named in the project and is not there; it cannot be collected</source>
        <translation>ist im Projekt genannt und nicht da; es lässt sich nicht einsammeln</translation>
    </message>
    <message>
        <source>is not empty and holds no project; name another folder</source>
        <translation>ist nicht leer und enthält kein Projekt; nennen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>is a damaged project ({0})</source>
        <translation>ist ein beschädigtes Projekt ({0})</translation>
    </message>
    <message>
        <source>has {0} parts, more than the {1} allowed</source>
        <translation>hat {0} Teile, mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>the part is there twice</source>
        <translation>der Teil kommt zweimal vor</translation>
    </message>
    <message>
        <source>is encrypted or packed by a method that projects do not have</source>
        <translation>ist verschlüsselt oder auf eine Weise gepackt, die Projekte nicht haben</translation>
    </message>
    <message>
        <source>expected {0} and plain files in {1}/</source>
        <translation>erwartet wurden {0} und einfache Dateien in {1}/</translation>
    </message>
    <message>
        <source>is a zip file without {0}</source>
        <translation>ist eine ZIP-Datei ohne {0}</translation>
    </message>
    <message>
        <source>{0} is larger than {1} MB</source>
        <translation>{0} ist größer als {1} MB</translation>
    </message>
    <message>
        <source>unpacks to more than {0} GB</source>
        <translation>ergibt entpackt mehr als {0} GB</translation>
    </message>
    <message>
        <source>expected an object, not {0}</source>
        <translation>erwartet wurde ein Objekt, nicht {0}</translation>
    </message>
    <message>
        <source>the top level</source>
        <translation>oberste Ebene</translation>
    </message>
    <message>
        <source>the field &quot;{0}&quot; is missing</source>
        <translation>das Feld „{0}“ fehlt</translation>
    </message>
    <message>
        <source>the field {0} is unknown</source>
        <translation>das Feld {0} ist unbekannt</translation>
    </message>
    <message>
        <source>is not text in UTF-8</source>
        <translation>ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>the field is given twice</source>
        <translation>das Feld ist zweimal angegeben</translation>
    </message>
    <message>
        <source>line {0}, column {1}</source>
        <translation>Zeile {0}, Spalte {1}</translation>
    </message>
    <message>
        <source>is not valid JSON ({0})</source>
        <translation>ist kein gültiges JSON ({0})</translation>
    </message>
    <message>
        <source>is nested too deep to be a document of ours</source>
        <translation>ist zu tief verschachtelt für ein Dokument der Suite</translation>
    </message>
    <message>
        <source>holds a number that cannot be read ({0})</source>
        <translation>enthält eine Zahl, die nicht lesbar ist ({0})</translation>
    </message>
    <message>
        <source>is larger than {0} MB, too large to be a document of ours</source>
        <translation>ist größer als {0} MB, zu groß für ein Dokument der Suite</translation>
    </message>
    <message>
        <source>expected &quot;{0}&quot;, not {1}</source>
        <translation>erwartet wurde „{0}“, nicht {1}</translation>
    </message>
    <message>
        <source>expected a whole number from 1, not {0}</source>
        <translation>erwartet wurde eine ganze Zahl ab 1, nicht {0}</translation>
    </message>
    <message>
        <source>version {0} is newer than this program, which knows up to {1}; update it</source>
        <translation>Version {0} ist neuer als dieses Programm, das bis {1} kennt; aktualisieren Sie es</translation>
    </message>
    <message>
        <source>version {0} is too old to be read</source>
        <translation>Version {0} ist zu alt, um gelesen zu werden</translation>
    </message>
    <message>
        <source>is of version {0} but not as that version was, so it cannot be brought up to date</source>
        <translation>hat die Version {0}, ist aber nicht wie diese aufgebaut und lässt sich daher nicht aktualisieren</translation>
    </message>
    <message>
        <source>the kinds known to this version are &quot;aspecular&quot;, &quot;cook_torrance&quot; and &quot;factored&quot;</source>
        <translation>dieser Version sind die Arten „aspecular“, „cook_torrance“ und „factored“ bekannt</translation>
    </message>
    <message>
        <source>a Cook-Torrance paint</source>
        <translation>einen Cook-Torrance-Lack</translation>
    </message>
    <message>
        <source>a factored paint</source>
        <translation>einen faktorisierten Lack</translation>
    </message>
    <message>
        <source>holds {0}; expected a paint of aspecular readings, which can be edited (brdf-suite render and fit take every kind)</source>
        <translation>enthält {0}; erwartet wurde ein Lack aus aspekularen Messwerten, der sich bearbeiten lässt (brdf-suite render und fit nehmen jede Art)</translation>
    </message>
    <message>
        <source>Of the lamp&apos;s middle</source>
        <translation>Der Lampenmitte</translation>
    </message>
    <message>
        <source>Where the lamp shines, a vector of any length</source>
        <translation>Wohin die Lampe leuchtet, ein Vektor beliebiger Länge</translation>
    </message>
    <message>
        <source>Both sides; outer diameter and width of a ring</source>
        <translation>Beide Seiten; bei einem Ring Außendurchmesser und Breite</translation>
    </message>
    <message>
        <source>In the unit of the studio</source>
        <translation>In der Einheit des Studios</translation>
    </message>
    <message>
        <source>Of the lamp&apos;s white</source>
        <translation>Des Weiß der Lampe</translation>
    </message>
    <message>
        <source>Over which the lamp&apos;s edge fades in</source>
        <translation>Über die der Rand der Lampe ausläuft</translation>
    </message>
    <message>
        <source>must lie below the ceiling, {0} m</source>
        <translation>muss unter der Decke liegen, {0} m</translation>
    </message>
    <message>
        <source>must be {0} m or more from the middle of the scene</source>
        <translation>muss {0} m oder mehr von der Mitte der Szene entfernt sein</translation>
    </message>
    <message>
        <source>a strip is at least as long as wide: length first, then width</source>
        <translation>ein Streifen ist mindestens so lang wie breit: zuerst die Länge, dann die Breite</translation>
    </message>
    <message>
        <source>a ring&apos;s band is at most half as wide as its outer diameter</source>
        <translation>das Band eines Rings ist höchstens halb so breit wie sein Außendurchmesser</translation>
    </message>
    <message>
        <source>expected either &quot;room&quot; or &quot;backdrop&quot;, and only one of them</source>
        <translation>erwartet wurde entweder „room“ oder „backdrop“, und nur eines davon</translation>
    </message>
    <message>
        <source>expected a list of lamps, not {0}</source>
        <translation>erwartet wurde eine Liste von Lampen, nicht {0}</translation>
    </message>
    <message>
        <source>{0} lamps are more than the {1} allowed</source>
        <translation>{0} Lampen sind mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>lies outside of the room</source>
        <translation>liegt außerhalb des Raums</translation>
    </message>
    <message>
        <source>nothing gives light: expected a lamp or a backdrop of luminance above 0</source>
        <translation>nichts gibt Licht: Erwartet wurde eine Lampe oder ein Hintergrund mit einer Leuchtdichte über 0</translation>
    </message>
    <message>
        <source>Preetham&apos;s model holds from 1.9 on; take hosek_wilkie below</source>
        <translation>Das Modell von Preetham gilt ab 1,9; nehmen Sie darunter hosek_wilkie</translation>
    </message>
    <message>
        <source>the kinds known to this version are &quot;studio&quot; and &quot;sky&quot;</source>
        <translation>dieser Version sind die Arten „studio“ und „sky“ bekannt</translation>
    </message>
    <message>
        <source>From the target to the camera</source>
        <translation>Vom Ziel zur Kamera</translation>
    </message>
    <message>
        <source>The point in the middle of the picture</source>
        <translation>Der Punkt in der Mitte des Bildes</translation>
    </message>
    <message>
        <source>Encoded sRGB</source>
        <translation>Kodiertes sRGB</translation>
    </message>
    <message>
        <source>expected the name of a packaged one or an absolute path, not {0}</source>
        <translation>erwartet wurde der Name einer mitgelieferten oder ein absoluter Pfad, nicht {0}</translation>
    </message>
    <message>
        <source>Where a point lamp is, y up</source>
        <translation>Wo eine Punktlampe steht, y nach oben</translation>
    </message>
    <message>
        <source>Colour temperature</source>
        <translation>Farbtemperatur</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Scale to</source>
        <translation>Skalieren auf</translation>
    </message>
    <message>
        <source>a part is named twice</source>
        <translation>ein Teil ist zweimal genannt</translation>
    </message>
    <message>
        <source>; did you mean {0}?</source>
        <translation>; meinten Sie {0}?</translation>
    </message>
    <message>
        <source>The task was cancelled.</source>
        <translation>Die Aufgabe wurde abgebrochen.</translation>
    </message>
    <message>
        <source>, at {0}</source>
        <translation>, {0}</translation>
    </message>
    <message>
        <source>Assimp (assimp-py)</source>
        <translation>Assimp (assimp-py)</translation>
    </message>
    <message>
        <source>Open CASCADE (cascadio)</source>
        <translation>Open CASCADE (cascadio)</translation>
    </message>
    <message>
        <source>OpenUSD (usd-core)</source>
        <translation>OpenUSD (usd-core)</translation>
    </message>
    <message>
        <source>ffmpeg (imageio-ffmpeg)</source>
        <translation>ffmpeg (imageio-ffmpeg)</translation>
    </message>
    <message>
        <source>install the system library {0} with the package manager of this system</source>
        <translation>installieren Sie die Systembibliothek {0} mit der Paketverwaltung dieses Systems</translation>
    </message>
    <message>
        <source>{0} needs {1}, which is installed but cannot be loaded ({2}); {3}</source>
        <translation>{0} braucht {1}, das installiert ist, sich aber nicht laden lässt ({2}); {3}</translation>
    </message>
    <message>
        <source>{0} needs {1}, which this build of BRDF Suite does not contain; {2}</source>
        <translation>{0} braucht {1}, das dieser Bau von BRDF Suite nicht enthält; {2}</translation>
    </message>
    <message>
        <source>{0} needs {1}, which this build of BRDF Suite does not contain</source>
        <translation>{0} braucht {1}, das dieser Bau von BRDF Suite nicht enthält</translation>
    </message>
    <message>
        <source>{0} needs {1}, which is not published for Python {2}; {3}</source>
        <translation>{0} braucht {1}, das es für Python {2} nicht gibt; {3}</translation>
    </message>
    <message>
        <source>{0} needs {1}, which is not published for Python {2}</source>
        <translation>{0} braucht {1}, das es für Python {2} nicht gibt</translation>
    </message>
    <message>
        <source>{0} needs {1}, which is not installed; {2}</source>
        <translation>{0} braucht {1}, das nicht installiert ist; {2}</translation>
    </message>
    <message>
        <source>{0} needs {1} {2} or later, and {3} is installed; {4}</source>
        <translation>{0} braucht {1} {2} oder neuer, installiert ist {3}; {4}</translation>
    </message>
    <message>
        <source>in a newer version</source>
        <translation>in einer neueren Version</translation>
    </message>
    <message>
        <source>install BRDF Suite again</source>
        <translation>installieren Sie BRDF Suite neu</translation>
    </message>
    <message>
        <source>`{0}` installs it{1}</source>
        <translation>`{0}` installiert es{1}</translation>
    </message>
    <message>
        <source>{0}, and {1}</source>
        <translation>{0}, und {1}</translation>
    </message>
    <message>
        <source>cannot be written: its facts are not plain values ({0})</source>
        <translation>lässt sich nicht schreiben: Seine Angaben sind keine einfachen Werte ({0})</translation>
    </message>
    <message>
        <source>cannot be written: its facts take {0} bytes, over {1}</source>
        <translation>lässt sich nicht schreiben: Seine Angaben nehmen {0} Byte ein, mehr als {1}</translation>
    </message>
    <message>
        <source>has {0} bytes that belong to no array</source>
        <translation>hat {0} Byte, die zu keiner Zahlenreihe gehören</translation>
    </message>
    <message>
        <source>has an array {0} that does not fit into it</source>
        <translation>hat eine Zahlenreihe {0}, die nicht hineinpasst</translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation>ist abgeschnitten</translation>
    </message>
    <message>
        <source>is damaged: a checksum of its arrays does not fit</source>
        <translation>ist beschädigt: Eine Prüfsumme seiner Zahlenreihen stimmt nicht</translation>
    </message>
    <message>
        <source>is no {0} (it does not begin with {1})</source>
        <translation>ist kein {0} (beginnt nicht mit {1})</translation>
    </message>
    <message>
        <source>is cut off within its first bytes</source>
        <translation>ist innerhalb seiner ersten Bytes abgeschnitten</translation>
    </message>
    <message>
        <source>is of version {0}; this program reads {1}</source>
        <translation>hat die Version {0}; dieses Programm liest {1}</translation>
    </message>
    <message>
        <source>is damaged or cut off: a header of {0} bytes is named</source>
        <translation>ist beschädigt oder abgeschnitten: Genannt ist ein Kopf von {0} Byte</translation>
    </message>
    <message>
        <source>is damaged: its checksum does not fit its content</source>
        <translation>ist beschädigt: Seine Prüfsumme passt nicht zum Inhalt</translation>
    </message>
    <message>
        <source>cannot be unpacked ({0})</source>
        <translation>lässt sich nicht entpacken ({0})</translation>
    </message>
    <message>
        <source>array {0}</source>
        <translation>Zahlenreihe {0}</translation>
    </message>
    <message>
        <source>unpacks to another size than its header says</source>
        <translation>ergibt entpackt eine andere Größe, als sein Kopf angibt</translation>
    </message>
    <message>
        <source>has a header that is not JSON ({0})</source>
        <translation>hat einen Kopf, der kein JSON ist ({0})</translation>
    </message>
    <message>
        <source>has a header that is no JSON object</source>
        <translation>hat einen Kopf, der kein JSON-Objekt ist</translation>
    </message>
    <message>
        <source>lists no arrays, or more than {0}</source>
        <translation>führt keine Zahlenreihen auf, oder mehr als {0}</translation>
    </message>
    <message>
        <source>header, arrays</source>
        <translation>Kopf, Zahlenreihen</translation>
    </message>
    <message>
        <source>header, arrays[{0}]</source>
        <translation>Kopf, arrays[{0}]</translation>
    </message>
    <message>
        <source>expected an object of {0}</source>
        <translation>erwartet wurde ein Objekt aus {0}</translation>
    </message>
    <message>
        <source>expected a name and one of {0}</source>
        <translation>erwartet wurden ein Name und eines von {0}</translation>
    </message>
    <message>
        <source>lists {0} twice, which does not fit</source>
        <translation>führt {0} zweimal auf, was nicht passt</translation>
    </message>
    <message>
        <source>expected a shape of at most {0} numbers</source>
        <translation>erwartet wurde eine Form von höchstens {0} Zahlen</translation>
    </message>
    <message>
        <source>expected a shape of positive whole numbers</source>
        <translation>erwartet wurde eine Form aus positiven ganzen Zahlen</translation>
    </message>
    <message>
        <source>expected at most {0} bytes of an array</source>
        <translation>erwartet wurden höchstens {0} Byte einer Zahlenreihe</translation>
    </message>
    <message>
        <source>cannot be read (its name holds a NUL character)</source>
        <translation>ist nicht lesbar (der Name enthält ein NUL-Zeichen)</translation>
    </message>
    <message>
        <source>(it is a folder)</source>
        <translation>(es ist ein Ordner)</translation>
    </message>
    <message>
        <source>is not a plain file{0}</source>
        <translation>ist keine einfache Datei{0}</translation>
    </message>
    <message>
        <source>has {0} bytes, more than the {1} that this format can need</source>
        <translation>hat {0} Byte, mehr als die {1}, die dieses Format brauchen kann</translation>
    </message>
    <message>
        <source>the line is longer than {0} bytes</source>
        <translation>die Zeile ist länger als {0} Byte</translation>
    </message>
    <message>
        <source>line {0}</source>
        <translation>Zeile {0}</translation>
    </message>
    <message>
        <source>holds a NUL byte, so it is not text</source>
        <translation>enthält ein NUL-Byte, ist also kein Text</translation>
    </message>
    <message>
        <source>expected a finite number for {0}, not {1}</source>
        <translation>erwartet wurde eine endliche Zahl ({0}), nicht {1}</translation>
    </message>
    <message>
        <source>more memory than there is</source>
        <translation>mehr Speicher, als es gibt</translation>
    </message>
    <message>
        <source>there is not enough memory for what it holds</source>
        <translation>für den Inhalt reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>The packaged {0} are made again: {1} Install brdf-suite again to repair them.</source>
        <translation>Mitgelieferte Daten ({0}) werden neu erzeugt: {1} Installieren Sie brdf-suite neu, um sie zu reparieren.</translation>
    </message>
    <message>
        <source>checking {0} of {1}</source>
        <translation>{0} von {1} wird geprüft</translation>
    </message>
    <message>
        <source>{0} cannot be removed.</source>
        <translation>{0} lässt sich nicht entfernen.</translation>
    </message>
    <message>
        <source>Damaged {0} are removed and made again: {1}</source>
        <translation>Beschädigte Daten ({0}) werden entfernt und neu erzeugt: {1}</translation>
    </message>
    <message>
        <source>The {0} are not kept: {1} MB do not fit into the cache&apos;s {2} MB; {3} sets another limit.</source>
        <translation>Nicht aufbewahrt ({0}): {1} MB passen nicht in die {2} MB des Zwischenspeichers; {3} setzt eine andere Grenze.</translation>
    </message>
    <message>
        <source>The {0} are not kept: {1} cannot be written ({2}). Make room there, or set {3} to another folder.</source>
        <translation>Zwischenspeicher nicht verfügbar ({0}): {1} lässt sich nicht beschreiben ({2}). Schaffen Sie dort Platz, oder setzen Sie {3} auf einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Waited {0} s for another program at the same work; continuing without it.</source>
        <translation>{0} s auf ein anderes Programm bei derselben Arbeit gewartet; es geht ohne es weiter.</translation>
    </message>
    <message>
        <source>The cache {0} cannot be locked ({1}).</source>
        <translation>Der Zwischenspeicher {0} lässt sich nicht sperren ({1}).</translation>
    </message>
    <message>
        <source>waiting for another program at the same work</source>
        <translation>wartet auf ein anderes Programm bei derselben Arbeit</translation>
    </message>
    <message>
        <source>paint version</source>
        <translation>Version des Lacks</translation>
    </message>
    <message>
        <source>is not CxF3: its root is {0}</source>
        <translation>ist kein CxF3: Das Wurzelelement ist {0}</translation>
    </message>
    <message>
        <source>holds no sample</source>
        <translation>enthält keine Probe</translation>
    </message>
    <message>
        <source>holds no sample read at several angles that can be used{0}</source>
        <translation>enthält keine brauchbare, bei mehreren Winkeln gemessene Probe{0}</translation>
    </message>
    <message>
        <source>{0} samples that were not read by a multi-angle instrument are left out</source>
        <translation>{0} Proben, die kein Mehrwinkelgerät gemessen hat, sind ausgelassen</translation>
    </message>
    <message>
        <source>{0} of {1} samples: L*a*b* is {2}.</source>
        <translation>{0} von {1} Proben: L*a*b* ist {2}.</translation>
    </message>
    <message>
        <source>“{0}” is the mean of up to {1} readings at an angle; they differ from it by at most ΔE00 {2}.</source>
        <translation>„{0}“ ist das Mittel aus bis zu {1} Messwerten je Winkel; sie weichen davon um höchstens ΔE00 {2} ab.</translation>
    </message>
    <message>
        <source>Sparkle and graininess are on the instrument&apos;s own scale; they are kept as notes.</source>
        <translation>Glitzern und Körnigkeit stehen auf der eigenen Skala des Geräts; sie bleiben als Notizen erhalten.</translation>
    </message>
    <message>
        <source>{0} of {1} samples say nothing of gloss; as paints they get 90 GU at 20°.</source>
        <translation>{0} von {1} Proben geben keinen Glanz an; als Lacke bekommen sie 90 GU bei 20°.</translation>
    </message>
    <message>
        <source>the ColorSpecification {0} is not in the file</source>
        <translation>die ColorSpecification {0} ist nicht in der Datei</translation>
    </message>
    <message>
        <source>a spectrum is left out: {0} ({1})</source>
        <translation>ein Spektrum ist ausgelassen: {0} ({1})</translation>
    </message>
    <message>
        <source>the colour at {0}as{1} is of {2}, and without a spectrum it cannot become that of D65 and 10°</source>
        <translation>die Farbe bei {0}as{1} gilt für {2} und lässt sich ohne Spektrum nicht auf D65 und 10° umrechnen</translation>
    </message>
    <message>
        <source>{0} lists {1} angles, and no name says which of them the value of line {2} was read at</source>
        <translation>{0} führt {1} Winkel auf, und kein Name sagt, bei welchem davon der Wert in Zeile {2} gemessen wurde</translation>
    </message>
    <message>
        <source>{0} is out of the plane of incidence ({1}°)</source>
        <translation>{0} liegt außerhalb der Einfallsebene ({1}°)</translation>
    </message>
    <message>
        <source>a reading</source>
        <translation>einen Messwert</translation>
    </message>
    <message>
        <source>a second, different colour at {0}as{1} (ΔE00 {2} from their mean)</source>
        <translation>eine zweite, andere Farbe bei {0}as{1} (ΔE00 {2} von ihrem Mittel)</translation>
    </message>
    <message>
        <source>on the scale {0}</source>
        <translation>auf der Skala {0}</translation>
    </message>
    <message>
        <source>on a scale that is not named</source>
        <translation>auf einer ungenannten Skala</translation>
    </message>
    <message>
        <source>the texture is {0}, not {1}</source>
        <translation>die Textur ist {0}, nicht {1}</translation>
    </message>
    <message>
        <source>{0}{1} must not be negative, is {2}</source>
        <translation>{0}{1} darf nicht negativ sein, ist {2}</translation>
    </message>
    <message>
        <source>neither it nor {0} says at which wavelengths it was read</source>
        <translation>weder es noch {0} sagt, bei welchen Wellenlängen gemessen wurde</translation>
    </message>
    <message>
        <source>a reflectance</source>
        <translation>eine Reflexion</translation>
    </message>
    <message>
        <source>expected a spectrum of 2 to {0} bands, not {1}</source>
        <translation>erwartet wurde ein Spektrum von 2 bis {0} Bändern, nicht {1}</translation>
    </message>
    <message>
        <source>the wavelengths of a spectrum must rise, from 100 to 10,000 nm</source>
        <translation>die Wellenlängen eines Spektrums müssen steigen, von 100 bis 10.000 nm</translation>
    </message>
    <message>
        <source>no stated illuminant</source>
        <translation>keine angegebene Lichtart</translation>
    </message>
    <message>
        <source>{0} and the {1} observer</source>
        <translation>{0} und der {1}-Beobachter</translation>
    </message>
    <message>
        <source>{0} has no {1}</source>
        <translation>{0} hat keine {1}</translation>
    </message>
    <message>
        <source>a ColorSpecification has no Id</source>
        <translation>eine ColorSpecification hat keine Id</translation>
    </message>
    <message>
        <source>two ColorSpecifications are called {0}</source>
        <translation>zwei ColorSpecifications heißen {0}</translation>
    </message>
    <message>
        <source>a MultiAngle has {0} angles; expected 1 to {1}</source>
        <translation>ein MultiAngle hat {0} Winkel; erwartet wurden 1 bis {1}</translation>
    </message>
    <message>
        <source>line {0}, {1}</source>
        <translation>Zeile {0}, {1}</translation>
    </message>
    <message>
        <source>holds no paints in a format that is read here ({0})</source>
        <translation>enthält keine Lacke in einem lesbaren Format ({0})</translation>
    </message>
    <message>
        <source>The spectra are left out.</source>
        <translation>Die Spektren sind ausgelassen.</translation>
    </message>
    <message>
        <source>is not text in UTF-8 or UTF-16</source>
        <translation>ist kein Text in UTF-8 oder UTF-16</translation>
    </message>
    <message>
        <source>is not valid CSV ({0})</source>
        <translation>ist kein gültiges CSV ({0})</translation>
    </message>
    <message>
        <source>the column {0} is there twice</source>
        <translation>die Spalte {0} kommt zweimal vor</translation>
    </message>
    <message>
        <source>has no columns name and L_15 (or of another angle), so it is no table of paints</source>
        <translation>hat keine Spalten name und L_15 (oder eines anderen Winkels), ist also keine Tabelle von Lacken</translation>
    </message>
    <message>
        <source>has more than {0} rows</source>
        <translation>hat mehr als {0} Zeilen</translation>
    </message>
    <message>
        <source>has more than {0} cells</source>
        <translation>hat mehr als {0} Zellen</translation>
    </message>
    <message>
        <source>holds no paint</source>
        <translation>enthält keinen Lack</translation>
    </message>
    <message>
        <source>The column {0} is none of a paint&apos;s and was skipped.</source>
        <translation>Die Spalte {0} gehört zu keinem Lack und wurde übergangen.</translation>
    </message>
    <message>
        <source>The table says nothing of gloss; the paints get 90 GU at 20°.</source>
        <translation>Die Tabelle gibt keinen Glanz an; die Lacke bekommen 90 GU bei 20°.</translation>
    </message>
    <message>
        <source>colours of {0} and the {1}° observer cannot become those of D65 and 10° without a spectrum</source>
        <translation>Farben von {0} und dem {1}°-Beobachter lassen sich ohne Spektrum nicht auf D65 und 10° umrechnen</translation>
    </message>
    <message>
        <source>L*a*b* at every angle (D65, 10°), gloss, flakes and every other setting of a designed paint, texts.</source>
        <translation>L*a*b* bei jedem Winkel (D65, 10°), Glanz, Flakes und jede weitere Einstellung eines entworfenen Lacks, Texte.</translation>
    </message>
    <message>
        <source>The {0}, the rule between angles</source>
        <translation>Die {0}, die Regel zwischen den Winkeln</translation>
    </message>
    <message>
        <source>The rule between angles</source>
        <translation>Die Regel zwischen den Winkeln</translation>
    </message>
    <message>
        <source>{0} and the near-specular factor go in as tags of this suite; other programs pass over them.</source>
        <translation>{0} und der Faktor nahe der Spiegelrichtung stehen als Marken dieser Suite darin; andere Programme übergehen sie.</translation>
    </message>
    <message>
        <source>Characters that XML does not know are written as �.</source>
        <translation>Zeichen, die XML nicht kennt, werden als � geschrieben.</translation>
    </message>
    <message>
        <source>The spectra are read off at 400 to 700 nm, every 10 nm: CxF3 wants even steps from 360 to 400 nm.</source>
        <translation>Die Spektren werden bei 400 bis 700 nm in Schritten von 10 nm abgelesen: CxF3 verlangt gleichmäßige Schritte ab 360 bis 400 nm.</translation>
    </message>
    <message>
        <source>{0} of {1} spectra are left out: a reflectance there is 3 or more, or -0.1 or less.</source>
        <translation>{0} von {1} Spektren sind ausgelassen: Ein Reflexionsgrad darin ist 3 oder mehr, oder -0,1 oder weniger.</translation>
    </message>
    <message>
        <source>Multi-angle colours of paints, D65 and 10° observer</source>
        <translation>Mehrwinkelfarben von Lacken, D65 und 10°-Beobachter</translation>
    </message>
    <message>
        <source>holds no sample that makes a paint ({0})</source>
        <translation>enthält keine Probe, die einen Lack ergibt ({0})</translation>
    </message>
    <message>
        <source>L*a*b* at every angle (D65, 10°), spectra where they are known, gloss, name, notes.</source>
        <translation>L*a*b* bei jedem Winkel (D65, 10°), Spektren, wo sie bekannt sind, Glanz, Name, Notizen.</translation>
    </message>
    <message>
        <source>expected as many finite numbers as wavelengths</source>
        <translation>erwartet wurden so viele endliche Zahlen wie Wellenlängen</translation>
    </message>
    <message>
        <source>{0} Read by virtual instruments.</source>
        <translation>{0} Von virtuellen Messgeräten abgelesen.</translation>
    </message>
    <message>
        <source>The flakes do not sparkle there: density, size and tilt are left out.</source>
        <translation>Die Flakes glitzern dort nicht: Dichte, Größe und Neigung entfallen.</translation>
    </message>
    <message>
        <source>The orange peel is left out: the surface is smooth there.</source>
        <translation>Die Orangenhaut entfällt: Die Oberfläche ist dort glatt.</translation>
    </message>
    <message>
        <source>Only what the virtual instruments read of it goes in: L*a*b* at {0} angles and gloss. How it reflects between and beyond them is left out.</source>
        <translation>Nur was die virtuellen Messgeräte ablesen, wird übernommen: L*a*b* bei {0} Winkeln und Glanz. Wie er dazwischen und darüber hinaus reflektiert, entfällt.</translation>
    </message>
    <message>
        <source>glTF in a renderer with multiple scattering (Blender)</source>
        <translation>glTF in einem Renderer mit Mehrfachstreuung (Blender)</translation>
    </message>
    <message>
        <source>The clearcoat of glTF has the index {0}, whatever the paint&apos;s.</source>
        <translation>Der Klarlack von glTF hat die Brechzahl {0}, gleich welche der Lack hat.</translation>
    </message>
    <message>
        <source>Viewers show no flakes: readings, gloss, flakes and texts go along in the material&apos;s extras, which only this suite reads.</source>
        <translation>Betrachter zeigen keine Flakes: Messwerte, Glanz, Flakes und Texte stehen in den Zusatzdaten des Materials, die nur diese Suite liest.</translation>
    </message>
    <message>
        <source>holds no paint of this suite</source>
        <translation>enthält keinen Lack dieser Suite</translation>
    </message>
    <message>
        <source>glTF, clearcoat (KHR_materials_clearcoat)</source>
        <translation>glTF, Klarlack (KHR_materials_clearcoat)</translation>
    </message>
    <message>
        <source>A matt colour and a lobe of another under a clearcoat of index 1.5; the readings in extras.</source>
        <translation>Eine matte Farbe und eine andersfarbige Keule unter einem Klarlack mit Brechzahl 1,5; die Messwerte in den Zusatzdaten.</translation>
    </message>
    <message>
        <source>The measured table itself is left out: what the virtual instruments read of it goes in.</source>
        <translation>Die gemessene Tabelle selbst entfällt: Übernommen wird, was die virtuellen Messgeräte ablesen.</translation>
    </message>
    <message>
        <source>expected &quot;{0}&quot;</source>
        <translation>erwartet wurde „{0}“</translation>
    </message>
    <message>
        <source>version {0} is known here, not {1}</source>
        <translation>bekannt ist hier Version {0}, nicht {1}</translation>
    </message>
    <message>
        <source>expected 1 to {0} paints, found {1}</source>
        <translation>erwartet wurden 1 bis {0} Lacke, gefunden {1}</translation>
    </message>
    <message>
        <source>holds data that are damaged ({0})</source>
        <translation>enthält beschädigte Daten ({0})</translation>
    </message>
    <message>
        <source>the paint in it</source>
        <translation>der Lack darin</translation>
    </message>
    <message>
        <source>JSON, paints with computed values</source>
        <translation>JSON, Lacke mit berechneten Werten</translation>
    </message>
    <message>
        <source>Everything of the paint&apos;s document; L*a*b*, LCh and XYZ at every angle, flop, travel, spectra where known.</source>
        <translation>Alles aus dem Dokument des Lacks; L*a*b*, LCh und XYZ bei jedem Winkel, Flop, Weg, Spektren, wo sie bekannt sind.</translation>
    </message>
    <message>
        <source>LuxCore&apos;s car paint (one lobe under a coat)</source>
        <translation>Autolack von LuxCore (eine Keule unter einem Klarlack)</translation>
    </message>
    <message>
        <source>A diffuse layer, a coloured lobe and a clearcoat, fitted on a sphere.</source>
        <translation>Eine diffuse Schicht, eine farbige Keule und ein Klarlack, an eine Kugel angepasst.</translation>
    </message>
    <message>
        <source>{0} at {1}°</source>
        <translation>{0} bei {1}°</translation>
    </message>
    <message>
        <source>{0} at {1}° (light {2}°)</source>
        <translation>{0} bei {1}° (Licht {2}°)</translation>
    </message>
    <message>
        <source>(light {0}°)</source>
        <translation>(Licht {0}°)</translation>
    </message>
    <message>
        <source>{0}: mean ΔE00 {1} on a sphere in the sun; {2}.</source>
        <translation>{0}: ΔE00 {1} im Mittel auf einer Kugel in der Sonne; {2}.</translation>
    </message>
    <message>
        <source>Gloss readings, notes and source are left out.</source>
        <translation>Glanzwerte, Notizen und Quelle entfallen.</translation>
    </message>
    <message>
        <source>A colour lies outside Rec. 709, in which the parameters are kept; it is moved to the edge.</source>
        <translation>Eine Farbe liegt außerhalb von Rec. 709, worin die Parameter gespeichert werden; sie ist auf den Rand gerückt.</translation>
    </message>
    <message>
        <source>OpenPBR in MaterialX</source>
        <translation>OpenPBR in MaterialX</translation>
    </message>
    <message>
        <source>{0}, by BRDF Suite {1}; ΔE00 at its readings: {2}</source>
        <translation>{0}, von BRDF Suite {1}; ΔE00 an den Messwerten: {2}</translation>
    </message>
    <message>
        <source>A matt colour and a lobe of another under a clearcoat, fitted on a sphere.</source>
        <translation>Eine matte Farbe und eine andersfarbige Keule unter einem Klarlack, an eine Kugel angepasst.</translation>
    </message>
    <message>
        <source>Name, gloss readings, notes and source are left out; nothing that is edited can be read back.</source>
        <translation>Name, Glanzwerte, Notizen und Quelle entfallen; nichts Bearbeitbares lässt sich zurücklesen.</translation>
    </message>
    <message>
        <source>The paint is tabulated: in the middle of the hemisphere within 2 in 10,000, near the horizon within percents.</source>
        <translation>Der Lack wird tabelliert: in der Mitte der Halbkugel auf 2 von 10.000 genau, nahe dem Horizont auf Prozente.</translation>
    </message>
    <message>
        <source>tabulating</source>
        <translation>Tabelle wird berechnet</translation>
    </message>
    <message>
        <source>How the paint reflects, for every pair of directions; spectra where they are known.</source>
        <translation>Wie der Lack reflektiert, für jedes Richtungspaar; Spektren, wo sie bekannt sind.</translation>
    </message>
    <message>
        <source>USD Preview Surface (one colour for every angle, so no change of hue)</source>
        <translation>USD Preview Surface (eine Farbe für alle Winkel, also kein Wechsel des Bunttons)</translation>
    </message>
    <message>
        <source>{0}; dE00 {1} on a sphere, at its readings {2}</source>
        <translation>{0}; dE00 {1} auf einer Kugel, an den Messwerten {2}</translation>
    </message>
    <message>
        <source>has {0} bytes, more than the {1} allowed</source>
        <translation>hat {0} Byte, mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>syntax error</source>
        <translation>Syntaxfehler</translation>
    </message>
    <message>
        <source>is not valid XML ({0})</source>
        <translation>ist kein gültiges XML ({0})</translation>
    </message>
    <message>
        <source>is in no encoding of text that can be read ({0})</source>
        <translation>ist in keiner lesbaren Textkodierung ({0})</translation>
    </message>
    <message>
        <source>holds no element</source>
        <translation>enthält kein Element</translation>
    </message>
    <message>
        <source>declares a document type or an entity, which no file of this kind needs</source>
        <translation>deklariert einen Dokumenttyp oder eine Entität, die keine Datei dieser Art braucht</translation>
    </message>
    <message>
        <source>has more than {0} elements</source>
        <translation>hat mehr als {0} Elemente</translation>
    </message>
    <message>
        <source>is nested deeper than {0} elements</source>
        <translation>ist tiefer als {0} Elemente verschachtelt</translation>
    </message>
    <message>
        <source>its root is {0}, not {1}</source>
        <translation>das Wurzelelement ist {0}, nicht {1}</translation>
    </message>
    <message>
        <source>is {0} × {1} pixels, too thin to be reduced to {2} × {3}</source>
        <translation>hat {0} × {1} Pixel, zu schmal, um auf {2} × {3} verkleinert zu werden</translation>
    </message>
    <message>
        <source>{0} rows of {1} pixels</source>
        <translation>{0} Zeilen von {1} Pixeln</translation>
    </message>
    <message>
        <source>{0} × {1} pixels were reduced by area to {2} × {3}</source>
        <translation>{0} × {1} Pixel wurden flächentreu auf {2} × {3} verkleinert</translation>
    </message>
    <message>
        <source>{0}, which is all that the lobes resolve</source>
        <translation>{0}, was alles ist, was die Keulen auflösen</translation>
    </message>
    <message>
        <source>infinite radiance; it was set to {0}</source>
        <translation>unendliche Strahldichte; sie wurde auf {0} gesetzt</translation>
    </message>
    <message>
        <source>radiance above {0}; it was set to {1}</source>
        <translation>Strahldichte über {0}; sie wurde auf {1} gesetzt</translation>
    </message>
    <message>
        <source>minus infinity; it was set to 0</source>
        <translation>minus unendlich; es wurde auf 0 gesetzt</translation>
    </message>
    <message>
        <source>radiance below -{0}; it was set to 0</source>
        <translation>Strahldichte unter -{0}; sie wurde auf 0 gesetzt</translation>
    </message>
    <message>
        <source>{0} held {1}</source>
        <translation>{0} enthielten {1}</translation>
    </message>
    <message>
        <source>{0} held no number (NaN); they were filled from their neighbours</source>
        <translation>{0} enthielten keine Zahl (NaN); sie wurden aus ihren Nachbarn gefüllt</translation>
    </message>
    <message>
        <source>no number (NaN), nor did their neighbours; they were set to 0</source>
        <translation>keine Zahl (NaN), ihre Nachbarn auch nicht; sie wurden auf 0 gesetzt</translation>
    </message>
    <message>
        <source>all of them</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>{0} ({1}) held negative radiance, down to {2}; clamped to 0</source>
        <translation>{0} ({1}) enthielten negative Strahldichte, bis {2}; auf 0 begrenzt</translation>
    </message>
    <message>
        <source>is {0} × {1} pixels, too small for an environment</source>
        <translation>hat {0} × {1} Pixel, zu klein für eine Umgebung</translation>
    </message>
    <message>
        <source>holds no number (NaN) in any pixel; there is nothing to repair it from</source>
        <translation>enthält in keinem Pixel eine Zahl (nur NaN); es gibt nichts, woraus es zu reparieren wäre</translation>
    </message>
    <message>
        <source>has unusable primaries: {0}</source>
        <translation>hat unbrauchbare Primärfarben: {0}</translation>
    </message>
    <message>
        <source>attribute chromaticities</source>
        <translation>Attribut chromaticities</translation>
    </message>
    <message>
        <source>every pixel is black: nothing is lit by this environment</source>
        <translation>jedes Pixel ist schwarz: Diese Umgebung beleuchtet nichts</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>is {0}; an environment must be an OpenEXR (.exr) or Radiance (.hdr) file</source>
        <translation>ist {0}; eine Umgebung muss eine OpenEXR- (.exr) oder Radiance-Datei (.hdr) sein</translation>
    </message>
    <message>
        <source>is neither an OpenEXR (.exr) nor a Radiance (.hdr) file, whatever its name says</source>
        <translation>ist weder eine OpenEXR- (.exr) noch eine Radiance-Datei (.hdr), was auch immer der Name sagt</translation>
    </message>
    <message>
        <source>is not an OpenEXR file (its first four bytes are not the magic number)</source>
        <translation>ist keine OpenEXR-Datei (die ersten vier Bytes sind nicht ihr Kennzeichen)</translation>
    </message>
    <message>
        <source>has OpenEXR version {0}; only version 2 is read</source>
        <translation>hat die OpenEXR-Version {0}; nur Version 2 wird gelesen</translation>
    </message>
    <message>
        <source>is a deep OpenEXR file; flatten it to an ordinary image first</source>
        <translation>ist eine OpenEXR-Datei mit Tiefenstapeln (deep); wandeln Sie sie zuerst in ein gewöhnliches Bild um</translation>
    </message>
    <message>
        <source>has more than {0} parts</source>
        <translation>hat mehr als {0} Teile</translation>
    </message>
    <message>
        <source>is tiled but lacks a sound &apos;tiles&apos; attribute</source>
        <translation>ist gekachelt, hat aber kein einwandfreies Attribut „tiles“</translation>
    </message>
    <message>
        <source>lacks the header attribute {0}</source>
        <translation>hat das Attribut {0} im Kopf nicht</translation>
    </message>
    <message>
        <source>has a compression that is not known</source>
        <translation>hat eine unbekannte Kompression</translation>
    </message>
    <message>
        <source>has a part without a sound &apos;chunkCount&apos; attribute</source>
        <translation>hat einen Teil ohne einwandfreies Attribut „chunkCount“</translation>
    </message>
    <message>
        <source>is cut off within its header</source>
        <translation>ist in seinem Kopf abgeschnitten</translation>
    </message>
    <message>
        <source>is cut off or damaged within a name of its header</source>
        <translation>ist in einem Namen seines Kopfs abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>has a damaged description of channel {0}</source>
        <translation>hat eine beschädigte Beschreibung des Kanals {0}</translation>
    </message>
    <message>
        <source>has no channels</source>
        <translation>hat keine Kanäle</translation>
    </message>
    <message>
        <source>has a damaged {0}</source>
        <translation>hat ein beschädigtes {0}</translation>
    </message>
    <message>
        <source>has a {0} of {1} × {2} pixels</source>
        <translation>hat ein {0} von {1} × {2} Pixeln</translation>
    </message>
    <message>
        <source>the limit is {0} pixels</source>
        <translation>die Grenze ist {0} Pixel</translation>
    </message>
    <message>
        <source>has a {0} of {1} × {2} pixels; {3}</source>
        <translation>hat ein {0} von {1} × {2} Pixeln; {3}</translation>
    </message>
    <message>
        <source>is incomplete: its writer was stopped before the end</source>
        <translation>ist unvollständig: Das Schreiben wurde vor dem Ende abgebrochen</translation>
    </message>
    <message>
        <source>is cut off: pixel data is expected at byte {0}</source>
        <translation>ist abgeschnitten: Bilddaten werden bei Byte {0} erwartet</translation>
    </message>
    <message>
        <source>holds deep data only; flatten it to an ordinary image first</source>
        <translation>enthält nur Tiefenstapel (deep); wandeln Sie sie zuerst in ein gewöhnliches Bild um</translation>
    </message>
    <message>
        <source>R, G and B, or Y with or without RY and BY</source>
        <translation>R, G und B, oder Y mit oder ohne RY und BY</translation>
    </message>
    <message>
        <source>has the channels {0}; expected {1}</source>
        <translation>hat die Kanäle {0}; erwartet wurden {1}</translation>
    </message>
    <message>
        <source>part {0} of {1}{2} was read</source>
        <translation>Teil {0} von {1}{2} wurde gelesen</translation>
    </message>
    <message>
        <source>layer {0} was read</source>
        <translation>Ebene {0} wurde gelesen</translation>
    </message>
    <message>
        <source>stored as luminance and chroma</source>
        <translation>als Helligkeit und Farbart gespeichert</translation>
    </message>
    <message>
        <source>one channel, Y: the light is taken as neutral</source>
        <translation>ein Kanal, Y: Das Licht gilt als neutral</translation>
    </message>
    <message>
        <source>holds integers, not radiance</source>
        <translation>enthält ganze Zahlen, keine Strahldichte</translation>
    </message>
    <message>
        <source>channel {0}</source>
        <translation>Kanal {0}</translation>
    </message>
    <message>
        <source>is stored at reduced resolution, which is not read</source>
        <translation>ist mit verringerter Auflösung gespeichert, die nicht gelesen wird</translation>
    </message>
    <message>
        <source>the data window {0} was placed in {1}; what lies outside is black</source>
        <translation>das Datenfenster {0} wurde in {1} gelegt; was außerhalb liegt, ist schwarz</translation>
    </message>
    <message>
        <source>attribute dataWindow</source>
        <translation>Attribut dataWindow</translation>
    </message>
    <message>
        <source>attribute displayWindow</source>
        <translation>Attribut displayWindow</translation>
    </message>
    <message>
        <source>its parts hold {0} MB together; {1} MB are read</source>
        <translation>seine Teile enthalten zusammen {0} MB; gelesen werden {1} MB</translation>
    </message>
    <message>
        <source>{0}. Write the part that is the light as a file of its own</source>
        <translation>{0}. Schreiben Sie den Teil, der das Licht ist, als eigene Datei</translation>
    </message>
    <message>
        <source>is damaged or cut off ({0})</source>
        <translation>ist beschädigt oder abgeschnitten ({0})</translation>
    </message>
    <message>
        <source>pixel data</source>
        <translation>Bilddaten</translation>
    </message>
    <message>
        <source>No copyright, use freely</source>
        <translation>Kein Urheberrecht, frei verwendbar</translation>
    </message>
    <message>
        <source>has channels whose colours are the same</source>
        <translation>hat Kanäle mit gleichen Farben</translation>
    </message>
    <message>
        <source>is not an ICC profile</source>
        <translation>ist kein ICC-Profil</translation>
    </message>
    <message>
        <source>is larger than {0} MB</source>
        <translation>ist größer als {0} MB</translation>
    </message>
    <message>
        <source>is of a device in {0}, not RGB</source>
        <translation>gehört zu einem Gerät in {0}, nicht RGB</translation>
    </message>
    <message>
        <source>connects by Lab, not by XYZ</source>
        <translation>verbindet über Lab, nicht über XYZ</translation>
    </message>
    <message>
        <source>says that it has {0} entries, which it is too short for</source>
        <translation>gibt {0} Einträge an, wofür es zu kurz ist</translation>
    </message>
    <message>
        <source>is cut off in its entry {0}</source>
        <translation>ist in seinem Eintrag {0} abgeschnitten</translation>
    </message>
    <message>
        <source>holds no XYZ colour</source>
        <translation>enthält keine XYZ-Farbe</translation>
    </message>
    <message>
        <source>is cut off in a curve</source>
        <translation>ist in einer Kurve abgeschnitten</translation>
    </message>
    <message>
        <source>has a curve of a kind ({0}) that is not known, or cut off</source>
        <translation>hat eine Kurve einer unbekannten Art ({0}), oder ist abgeschnitten</translation>
    </message>
    <message>
        <source>has a curve of a kind that is not known</source>
        <translation>hat eine Kurve einer unbekannten Art</translation>
    </message>
    <message>
        <source>has a curve that does not rise from black to white</source>
        <translation>hat eine Kurve, die nicht von Schwarz nach Weiß steigt</translation>
    </message>
    <message>
        <source>{0} picture</source>
        <translation>{0}-Bild</translation>
    </message>
    <message>
        <source>picture ({0})</source>
        <translation>Bild ({0})</translation>
    </message>
    <message>
        <source>is no {0} that can be read</source>
        <translation>ist kein lesbares {0}</translation>
    </message>
    <message>
        <source>has too many pixels to be read</source>
        <translation>hat zu viele Pixel, um gelesen zu werden</translation>
    </message>
    <message>
        <source>is damaged, or no {0} that can be read: {1}</source>
        <translation>ist beschädigt oder kein lesbares {0}: {1}</translation>
    </message>
    <message>
        <source>is not a Radiance picture (it does not begin with #?RADIANCE)</source>
        <translation>ist kein Radiance-Bild (beginnt nicht mit #?RADIANCE)</translation>
    </message>
    <message>
        <source>stored as XYZ</source>
        <translation>als XYZ gespeichert</translation>
    </message>
    <message>
        <source>is cut off or damaged within its header</source>
        <translation>ist in seinem Kopf abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>has the pixel format {0}, which is not read</source>
        <translation>hat das Pixelformat {0}, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>line FORMAT</source>
        <translation>Zeile FORMAT</translation>
    </message>
    <message>
        <source>has no size line such as &apos;-Y 512 +X 1024&apos;</source>
        <translation>hat keine Größenzeile wie „-Y 512 +X 1024“</translation>
    </message>
    <message>
        <source>{0} × {1} pixels</source>
        <translation>{0} × {1} Pixel</translation>
    </message>
    <message>
        <source>claims {0}; 1 to {1} are read</source>
        <translation>gibt {0} an; gelesen werden 1 bis {1}</translation>
    </message>
    <message>
        <source>is cut off: {0} lines do not fit into it</source>
        <translation>ist abgeschnitten: {0} Zeilen passen nicht hinein</translation>
    </message>
    <message>
        <source>is cut off at line {0} of {1}</source>
        <translation>ist in Zeile {0} von {1} abgeschnitten</translation>
    </message>
    <message>
        <source>is damaged: line {0} is not {1} pixels long</source>
        <translation>ist beschädigt: Zeile {0} ist nicht {1} Pixel lang</translation>
    </message>
    <message>
        <source>is cut off at line {0}</source>
        <translation>ist in Zeile {0} abgeschnitten</translation>
    </message>
    <message>
        <source>is damaged: a run of line {0} does not fit</source>
        <translation>ist beschädigt: Eine Lauflänge in Zeile {0} passt nicht</translation>
    </message>
    <message>
        <source>has {0} where a number belongs</source>
        <translation>hat {0}, wo eine Zahl hingehört</translation>
    </message>
    <message>
        <source>has one channel; a normal map has three (a height map is none)</source>
        <translation>hat einen Kanal; eine Normalenkarte hat drei (eine Höhenkarte ist keine)</translation>
    </message>
    <message>
        <source>is no normal map: {0} % of its pixels are unit vectors off a surface</source>
        <translation>ist keine Normalenkarte: {0} % der Pixel sind Einheitsvektoren von einer Oberfläche weg</translation>
    </message>
    <message>
        <source>has one channel; a tangent map has two or more (directions along u and v)</source>
        <translation>hat einen Kanal; eine Tangentenkarte hat zwei oder mehr (Richtungen entlang u und v)</translation>
    </message>
    <message>
        <source>is no tangent map: {0} % of its pixels are unit vectors in the surface</source>
        <translation>ist keine Tangentenkarte: {0} % der Pixel sind Einheitsvektoren in der Oberfläche</translation>
    </message>
    <message>
        <source>holds numbers that are not finite</source>
        <translation>enthält Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
        <source>is of no measured format that is known here ({0})</source>
        <translation>hat kein hier bekanntes Messformat ({0})</translation>
    </message>
    <message>
        <source>the ending {0} names no format that is written here ({1})</source>
        <translation>die Endung {0} nennt kein Format, das hier geschrieben wird ({1})</translation>
    </message>
    <message>
        <source>a number of columns</source>
        <translation>eine Anzahl von Spalten</translation>
    </message>
    <message>
        <source>{0} is no number of columns</source>
        <translation>{0} ist keine Anzahl von Spalten</translation>
    </message>
    <message>
        <source>the header, before line {0}</source>
        <translation>der Kopf, vor Zeile {0}</translation>
    </message>
    <message>
        <source>PARAM_IN is {0}; expected one of {1}</source>
        <translation>PARAM_IN ist {0}; erwartet wurde eines von {1}</translation>
    </message>
    <message>
        <source>PARAM_OUT is {0}; expected one of {1}</source>
        <translation>PARAM_OUT ist {0}; erwartet wurde eines von {1}</translation>
    </message>
    <message>
        <source>{0} has {1} inputs; DIM says {2}</source>
        <translation>{0} hat {1} Eingänge; DIM sagt {2}</translation>
    </message>
    <message>
        <source>{0} outputs; {1} are known</source>
        <translation>{0} Ausgänge; bekannt sind {1}</translation>
    </message>
    <message>
        <source>expected {0} numbers, not {1}</source>
        <translation>erwartet wurden {0} Zahlen, nicht {1}</translation>
    </message>
    <message>
        <source>a coordinate or a value</source>
        <translation>eine Koordinate oder ein Wert</translation>
    </message>
    <message>
        <source>the file ends before the first row</source>
        <translation>die Datei endet vor der ersten Zeile</translation>
    </message>
    <message>
        <source>ALTA text</source>
        <translation>ALTA-Text</translation>
    </message>
    <message>
        <source>The spectra were left out: this format holds colours.</source>
        <translation>Die Spektren sind ausgelassen: Dieses Format enthält Farben.</translation>
    </message>
    <message>
        <source>ASTM text</source>
        <translation>ASTM-Text</translation>
    </message>
    <message>
        <source>an angle or a value</source>
        <translation>ein Winkel oder ein Wert</translation>
    </message>
    <message>
        <source>the file ends before the line VARS</source>
        <translation>die Datei endet vor der Zeile VARS</translation>
    </message>
    <message>
        <source>NUM_POINTS announces {0} samples, the file holds {1}</source>
        <translation>NUM_POINTS kündigt {0} Messpunkte an, die Datei enthält {1}</translation>
    </message>
    <message>
        <source>{0} variables are too many</source>
        <translation>{0} Variablen sind zu viele</translation>
    </message>
    <message>
        <source>theta_i, phi_i, theta_s, phi_s and at least one value</source>
        <translation>theta_i, phi_i, theta_s, phi_s und mindestens ein Wert</translation>
    </message>
    <message>
        <source>VARS must name {0}</source>
        <translation>VARS muss {0} nennen</translation>
    </message>
    <message>
        <source>a wavelength</source>
        <translation>eine Wellenlänge</translation>
    </message>
    <message>
        <source>the value columns must be R,G,B or X,Y,Z, wavelengths like 550nm, or one alone</source>
        <translation>die Wertspalten müssen R,G,B oder X,Y,Z, Wellenlängen wie 550nm oder eine einzelne sein</translation>
    </message>
    <message>
        <source>ASTM E1392-style text</source>
        <translation>Text nach Art von ASTM E1392</translation>
    </message>
    <message>
        <source>readings of several polarizations averaged</source>
        <translation>Werte mehrerer Polarisationen gemittelt</translation>
    </message>
    <message>
        <source>{0} geometries times {1} wavelengths are more than {2} readings</source>
        <translation>{0} Geometrien mal {1} Wellenlängen sind mehr als {2} Messwerte</translation>
    </message>
    <message>
        <source>not every geometry was read at every wavelength ({0})</source>
        <translation>nicht jede Geometrie wurde bei jeder Wellenlänge gemessen ({0})</translation>
    </message>
    <message>
        <source>not every geometry was read at every wavelength</source>
        <translation>nicht jede Geometrie wurde bei jeder Wellenlänge gemessen</translation>
    </message>
    <message>
        <source>data, entry {0}</source>
        <translation>data, Eintrag {0}</translation>
    </message>
    <message>
        <source>the JSON text</source>
        <translation>der JSON-Text</translation>
    </message>
    <message>
        <source>does not follow the BRDF schema: {0} is a required property</source>
        <translation>folgt nicht dem BRDF-Schema: {0} ist eine Pflichtangabe</translation>
    </message>
    <message>
        <source>a list of 1 to {0} entries</source>
        <translation>eine Liste von 1 bis {0} Einträgen</translation>
    </message>
    <message>
        <source>does not follow the BRDF schema: {0} where {1} is expected</source>
        <translation>folgt nicht dem BRDF-Schema: {0}, wo {1} erwartet wird</translation>
    </message>
    <message>
        <source>has {0} entries where BRDF has {1}</source>
        <translation>hat {0} Einträge, wo BRDF {1} hat</translation>
    </message>
    <message>
        <source>this format holds spectra or grey values, and the reflectance has colours only</source>
        <translation>dieses Format enthält Spektren oder Grauwerte, und die Reflexion hat nur Farben</translation>
    </message>
    <message>
        <source>expected &quot;logarithmic&quot;, &quot;more&quot; and &quot;peak&quot; in the header</source>
        <translation>erwartet wurden „logarithmic“, „more“ und „peak“ im Kopf</translation>
    </message>
    <message>
        <source>there are arrays that no factor reads</source>
        <translation>es gibt Zahlenreihen, die kein Faktor liest</translation>
    </message>
    <message>
        <source>{0}: expected a list of at most {1} factors</source>
        <translation>{0}: Erwartet wurde eine Liste von höchstens {1} Faktoren</translation>
    </message>
    <message>
        <source>expected a name, a projection and true or false, and the array</source>
        <translation>erwartet wurden ein Name, eine Projektion und wahr oder falsch, und die Zahlenreihe</translation>
    </message>
    <message>
        <source>.brdftable file</source>
        <translation>.brdftable-Datei</translation>
    </message>
    <message>
        <source>expected the format &quot;brdftable&quot;</source>
        <translation>erwartet wurde das Format „brdftable“</translation>
    </message>
    <message>
        <source>header, format</source>
        <translation>Kopf, Format</translation>
    </message>
    <message>
        <source>has version {0}; this program reads {1}</source>
        <translation>hat die Version {0}; dieses Programm liest {1}</translation>
    </message>
    <message>
        <source>header, version</source>
        <translation>Kopf, Version</translation>
    </message>
    <message>
        <source>expected one of {0}</source>
        <translation>erwartet wurde eines von {0}</translation>
    </message>
    <message>
        <source>header, kind</source>
        <translation>Kopf, Art</translation>
    </message>
    <message>
        <source>lacks the array {0}</source>
        <translation>hat die Zahlenreihe {0} nicht</translation>
    </message>
    <message>
        <source>has an unknown array {0}</source>
        <translation>hat eine unbekannte Zahlenreihe {0}</translation>
    </message>
    <message>
        <source>is missing or no {0}</source>
        <translation>fehlt oder ist kein {0}</translation>
    </message>
    <message>
        <source>header, {0}</source>
        <translation>Kopf, {0}</translation>
    </message>
    <message>
        <source>is unknown</source>
        <translation>ist unbekannt</translation>
    </message>
    <message>
        <source>holds {0}; expected {1}</source>
        <translation>enthält {0}; erwartet wurde {1}</translation>
    </message>
    <message>
        <source>holds something else than 0 and 1</source>
        <translation>enthält anderes als 0 und 1</translation>
    </message>
    <message>
        <source>samples and deviation belong together; one of them is missing</source>
        <translation>Messpunkte und Abweichung gehören zusammen; eines davon fehlt</translation>
    </message>
    <message>
        <source>counts readings in a bin that holes says was not measured</source>
        <translation>zählt Messwerte in einem Feld, das laut holes nicht gemessen wurde</translation>
    </message>
    <message>
        <source>BRDF Suite table</source>
        <translation>BRDF-Suite-Tabelle</translation>
    </message>
    <message>
        <source>Cook-Torrance parameters</source>
        <translation>Cook-Torrance-Parameter</translation>
    </message>
    <message>
        <source>linear Rec. 2020</source>
        <translation>lineares Rec. 2020</translation>
    </message>
    <message>
        <source>is a paint designed by its colours, not measured lobes; open it as a paint</source>
        <translation>ist ein über seine Farben entworfener Lack, keine gemessenen Keulen; öffnen Sie ihn als Lack</translation>
    </message>
    <message>
        <source>this format holds Cook-Torrance lobes, and the reflectance is not made of them</source>
        <translation>dieses Format enthält Cook-Torrance-Keulen, und die Reflexion besteht nicht daraus</translation>
    </message>
    <message>
        <source>Cook-Torrance parameters (JSON)</source>
        <translation>Cook-Torrance-Parameter (JSON)</translation>
    </message>
    <message>
        <source>{0} wavelengths are named where {1} were announced</source>
        <translation>{0} Wellenlängen sind genannt, angekündigt waren {1}</translation>
    </message>
    <message>
        <source>expected {0} numbers (four angles, {1} values), not {2}</source>
        <translation>erwartet wurden {0} Zahlen (vier Winkel, {1} Werte), nicht {2}</translation>
    </message>
    <message>
        <source>the file ends before the first sample</source>
        <translation>die Datei endet vor dem ersten Messpunkt</translation>
    </message>
    <message>
        <source>Cornell text</source>
        <translation>Cornell-Text</translation>
    </message>
    <message>
        <source>expected the number of wavelengths, alone on its line</source>
        <translation>erwartet wurde die Anzahl der Wellenlängen, allein in ihrer Zeile</translation>
    </message>
    <message>
        <source>{0} wavelengths; expected 1 to {1}</source>
        <translation>{0} Wellenlängen; erwartet wurden 1 bis {1}</translation>
    </message>
    <message>
        <source>this format holds spectra, and the reflectance has colours only</source>
        <translation>dieses Format enthält Spektren, und die Reflexion hat nur Farben</translation>
    </message>
    <message>
        <source>Cornell text (spectral, scattered)</source>
        <translation>Cornell-Text (spektral, verstreut)</translation>
    </message>
    <message>
        <source>tabulated in 90 × 90 × 180 half-angle bins, as an isotropic and reciprocal reflectance</source>
        <translation>in 90 × 90 × 180 Halbwinkelfeldern tabelliert, als isotrope und reziproke Reflexion</translation>
    </message>
    <message>
        <source>its spectra were left out; the colours are those of the chosen observer under D65</source>
        <translation>seine Spektren sind ausgelassen; die Farben sind die des gewählten Beobachters unter D65</translation>
    </message>
    <message>
        <source>has more than {0} rows of samples</source>
        <translation>hat mehr als {0} Zeilen mit Messpunkten</translation>
    </message>
    <message>
        <source>{0} wavelengths are named; expected 1 to {1}</source>
        <translation>{0} Wellenlängen sind genannt; erwartet wurden 1 bis {1}</translation>
    </message>
    <message>
        <source>the wavelengths do not rise from at least 100 to at most 10,000 nm</source>
        <translation>die Wellenlängen steigen nicht von mindestens 100 bis höchstens 10.000 nm</translation>
    </message>
    <message>
        <source>holds no samples</source>
        <translation>enthält keine Messpunkte</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>a value is too large for a reflectance</source>
        <translation>ein Wert ist zu groß für eine Reflexion</translation>
    </message>
    <message>
        <source>{0} bands, {1} to {2} nm</source>
        <translation>{0} Bänder, {1} bis {2} nm</translation>
    </message>
    <message>
        <source>The spectra reach from {0} to {1} nm only; beyond, their last value is held, and colours are as good as that guess.</source>
        <translation>Die Spektren reichen nur von {0} bis {1} nm; darüber hinaus gilt ihr letzter Wert, und Farben sind so gut wie diese Annahme.</translation>
    </message>
    <message>
        <source>Read at {0} pairs of directions, as an isotropic reflectance.</source>
        <translation>Bei {0} Richtungspaaren abgelesen, als isotrope Reflexion.</translation>
    </message>
    <message>
        <source>every bin is negative, which means not measured</source>
        <translation>jedes Feld ist negativ, also nicht gemessen</translation>
    </message>
    <message>
        <source>whether it carries MERL&apos;s scale factors is uncertain (its reflectance without them is {0}); it was read as carrying them</source>
        <translation>ob es die Skalierungsfaktoren von MERL trägt, ist unsicher (ohne sie ist seine Reflexion {0}); gelesen wurde es, als trüge es sie</translation>
    </message>
    <message>
        <source>whether it carries MERL&apos;s scale factors is uncertain (its reflectance without them is {0}); it was read as plain f_r</source>
        <translation>ob es die Skalierungsfaktoren von MERL trägt, ist unsicher (ohne sie ist seine Reflexion {0}); gelesen wurde es als reines f_r</translation>
    </message>
    <message>
        <source>carrying them</source>
        <translation>tragen</translation>
    </message>
    <message>
        <source>plain f_r</source>
        <translation>reines f_r</translation>
    </message>
    <message>
        <source>it holds plain f_r, without MERL&apos;s scale factors, judged by its energy</source>
        <translation>es enthält reines f_r, ohne die Skalierungsfaktoren von MERL, nach seiner Energie beurteilt</translation>
    </message>
    <message>
        <source>{0} bins above the horizon were not measured and were filled from their neighbours</source>
        <translation>{0} Felder über dem Horizont wurden nicht gemessen und aus ihren Nachbarn gefüllt</translation>
    </message>
    <message>
        <source>the user</source>
        <translation>Benutzerangabe</translation>
    </message>
    <message>
        <source>a pair and its swap were averaged</source>
        <translation>ein Paar und sein Tausch wurden gemittelt</translation>
    </message>
    <message>
        <source>a pair and its swap were averaged: the layout holds φd from 0 to 180°</source>
        <translation>ein Paar und sein Tausch wurden gemittelt: Die Anordnung enthält φd von 0 bis 180°</translation>
    </message>
    <message>
        <source>{0} bins are too saturated for Rec. 709; their negative channels were written as 0</source>
        <translation>{0} Felder sind für Rec. 709 zu gesättigt; ihre negativen Kanäle wurden als 0 geschrieben</translation>
    </message>
    <message>
        <source>became shorter while it was read</source>
        <translation>wurde beim Lesen kürzer</translation>
    </message>
    <message>
        <source>holds a value that is no finite reflectance</source>
        <translation>enthält einen Wert, der keine endliche Reflexion ist</translation>
    </message>
    <message>
        <source>is cut off: {0} bytes are less than a header</source>
        <translation>ist abgeschnitten: {0} Byte sind weniger als ein Kopf</translation>
    </message>
    <message>
        <source>claims {0} × {1} × {2} bins, so it is not a MERL table</source>
        <translation>gibt {0} × {1} × {2} Felder an, ist also keine MERL-Tabelle</translation>
    </message>
    <message>
        <source>its header names {0} bins of φd; the file holds {1}, over 180°</source>
        <translation>sein Kopf nennt {0} Felder von φd; die Datei enthält {1}, über 180°</translation>
    </message>
    <message>
        <source>has {0} bins of φd beside {1} of θd; {2} (over 180°) or {3} are known</source>
        <translation>hat {0} Felder von φd neben {1} von θd; bekannt sind {2} (über 180°) oder {3}</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgeschnitten</translation>
    </message>
    <message>
        <source>too long</source>
        <translation>zu lang</translation>
    </message>
    <message>
        <source>is {0}: {1} × {2} × {3} bins take {4} bytes, the file has {5}</source>
        <translation>ist {0}: {1} × {2} × {3} Felder nehmen {4} Byte ein, die Datei hat {5}</translation>
    </message>
    <message>
        <source>MERL isotropic table</source>
        <translation>MERL, isotrope Tabelle</translation>
    </message>
    <message>
        <source>is no text in UTF-8</source>
        <translation>ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>its text</source>
        <translation>der Text</translation>
    </message>
    <message>
        <source>its shader</source>
        <translation>der Shader</translation>
    </message>
    <message>
        <source>Model text (GLSL of the BRDF Explorer, or Python’s notation)</source>
        <translation>Modelltext (GLSL des BRDF Explorer oder Schreibweise von Python)</translation>
    </message>
    <message>
        <source>the incident angle</source>
        <translation>der Einfallswinkel</translation>
    </message>
    <message>
        <source>the incident azimuth</source>
        <translation>das Azimut des Einfalls</translation>
    </message>
    <message>
        <source>expected theta, phi and one value, not {0} numbers</source>
        <translation>erwartet wurden Theta, Phi und ein Wert, nicht {0} Zahlen</translation>
    </message>
    <message>
        <source>no header names the incident angle</source>
        <translation>kein Kopf nennt den Einfallswinkel</translation>
    </message>
    <message>
        <source>the lines that begin with #</source>
        <translation>die Zeilen, die mit # beginnen</translation>
    </message>
    <message>
        <source>no header names the format</source>
        <translation>kein Kopf nennt das Format</translation>
    </message>
    <message>
        <source>{0}; expected theta phi BSDF or DSF</source>
        <translation>{0}; erwartet wurde theta phi BSDF oder DSF</translation>
    </message>
    <message>
        <source>pgII text</source>
        <translation>pgII-Text</translation>
    </message>
    <message>
        <source>pgII gonioreflectometer text</source>
        <translation>pgII-Goniometertext</translation>
    </message>
    <message>
        <source>the file ends within {0}</source>
        <translation>die Datei endet innerhalb von {0}</translation>
    </message>
    <message>
        <source>does not begin with &quot;tensor_file&quot;</source>
        <translation>beginnt nicht mit „tensor_file“</translation>
    </message>
    <message>
        <source>the version</source>
        <translation>die Version</translation>
    </message>
    <message>
        <source>has version {0}.{1}; only 1.x is known</source>
        <translation>hat die Version {0}.{1}; bekannt ist nur 1.x</translation>
    </message>
    <message>
        <source>the number of fields</source>
        <translation>die Anzahl der Felder</translation>
    </message>
    <message>
        <source>names {0} fields, more than the {1} allowed</source>
        <translation>nennt {0} Felder, mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>the name of a field</source>
        <translation>der Name eines Feldes</translation>
    </message>
    <message>
        <source>the file ends within the name of a field</source>
        <translation>die Datei endet im Namen eines Feldes</translation>
    </message>
    <message>
        <source>the field {0}</source>
        <translation>das Feld {0}</translation>
    </message>
    <message>
        <source>the field {0} has the unknown type {1}</source>
        <translation>das Feld {0} hat den unbekannten Typ {1}</translation>
    </message>
    <message>
        <source>the field {0} has {1} dimensions</source>
        <translation>das Feld {0} hat {1} Dimensionen</translation>
    </message>
    <message>
        <source>the field {0} of shape {1} does not fit into the file</source>
        <translation>das Feld {0} der Form {1} passt nicht in die Datei</translation>
    </message>
    <message>
        <source>the field {0} is given twice</source>
        <translation>das Feld {0} ist zweimal angegeben</translation>
    </message>
    <message>
        <source>{0} bands are more than the {1} allowed</source>
        <translation>{0} Bänder sind mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>{0} channels; expected {1}</source>
        <translation>{0} Kanäle; erwartet wurden {1}</translation>
    </message>
    <message>
        <source>expected one byte</source>
        <translation>erwartet wurde ein Byte</translation>
    </message>
    <message>
        <source>the field {0} is missing</source>
        <translation>das Feld {0} fehlt</translation>
    </message>
    <message>
        <source>the list of fields</source>
        <translation>die Liste der Felder</translation>
    </message>
    <message>
        <source>expected bytes, not {0} of shape {1}</source>
        <translation>erwartet wurden Bytes, nicht {0} der Form {1}</translation>
    </message>
    <message>
        <source>expected float32 of {0} dimensions, not {1} {2}</source>
        <translation>erwartet wurde float32 mit {0} Dimensionen, nicht {1} {2}</translation>
    </message>
    <message>
        <source>holds a number that is not finite</source>
        <translation>enthält eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>holds a number over 1e30</source>
        <translation>enthält eine Zahl über 1e30</translation>
    </message>
    <message>
        <source>expected numbers rising within {0} and {1}</source>
        <translation>erwartet wurden steigende Zahlen innerhalb von {0} und {1}</translation>
    </message>
    <message>
        <source>the shape {0} does not begin with {1}, the incident directions</source>
        <translation>die Form {0} beginnt nicht mit {1}, den Einfallsrichtungen</translation>
    </message>
    <message>
        <source>expected grids of at least 2 x 2, not shape {0}</source>
        <translation>erwartet wurden Raster von mindestens 2 x 2, nicht Form {0}</translation>
    </message>
    <message>
        <source>a density is negative</source>
        <translation>eine Dichte ist negativ</translation>
    </message>
    <message>
        <source>the density of an incident direction is zero everywhere</source>
        <translation>die Dichte einer Einfallsrichtung ist überall null</translation>
    </message>
    <message>
        <source>cannot be written: the {0} {1}</source>
        <translation>lässt sich nicht schreiben: {0} {1}</translation>
    </message>
    <message>
        <source>Tabulated: for a paint, interpolation errs by about 2 in 10,000 in the middle of the hemisphere, and by percents within some degrees of the horizon.</source>
        <translation>Tabelliert: Bei einem Lack irrt die Interpolation um etwa 2 von 10.000 in der Mitte der Halbkugel und um Prozente innerhalb einiger Grad vom Horizont.</translation>
    </message>
    <message>
        <source>Some colours lie outside Rec. 709; a renderer may take their negative channel as 0.</source>
        <translation>Einige Farben liegen außerhalb von Rec. 709; ein Renderer kann ihren negativen Kanal als 0 nehmen.</translation>
    </message>
    <message>
        <source>RGL material (adaptive parameterization)</source>
        <translation>RGL-Material (adaptive Parametrisierung)</translation>
    </message>
    <message>
        <source>is {0}: expected {1} bytes, found {2}</source>
        <translation>ist {0}: erwartet wurden {1} Byte, gefunden {2}</translation>
    </message>
    <message>
        <source>every value is negative, which no reflectance is</source>
        <translation>jeder Wert ist negativ, was keine Reflexion ist</translation>
    </message>
    <message>
        <source>{0} negative values became 0</source>
        <translation>{0} negative Werte wurden zu 0</translation>
    </message>
    <message>
        <source>θ {0} × φ {1}, of light and of view</source>
        <translation>θ {0} × φ {1}, von Licht und Blick</translation>
    </message>
    <message>
        <source>RGB, Rec. 709, sRGB-encoded</source>
        <translation>RGB, Rec. 709, sRGB-kodiert</translation>
    </message>
    <message>
        <source>RGB, Rec. 709, taken as linear</source>
        <translation>RGB, Rec. 709, als linear angenommen</translation>
    </message>
    <message>
        <source>, sRGB-encoded</source>
        <translation>, sRGB-kodiert</translation>
    </message>
    <message>
        <source>, taken as linear</source>
        <translation>, als linear angenommen</translation>
    </message>
    <message>
        <source>it reflects {0} of the light that falls on it at 45°, so its values are not f_r as they stand</source>
        <translation>es reflektiert {0} des bei 45° einfallenden Lichts, seine Werte sind also so nicht f_r</translation>
    </message>
    <message>
        <source>UTIA anisotropic table</source>
        <translation>UTIA, anisotrope Tabelle</translation>
    </message>
    <message>
        <source>the file ends before {0}</source>
        <translation>die Datei endet, bevor {0} kommt</translation>
    </message>
    <message>
        <source>the block {0}</source>
        <translation>der Block {0}</translation>
    </message>
    <message>
        <source>expected the block {0}, not {1}</source>
        <translation>erwartet wurde der Block {0}, nicht {1}</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>die Daten</translation>
    </message>
    <message>
        <source>expected a word of the head, not {0}</source>
        <translation>erwartet wurde ein Wort des Kopfs, nicht {0}</translation>
    </message>
    <message>
        <source>the head has no {0}</source>
        <translation>im Kopf fehlt {0}</translation>
    </message>
    <message>
        <source>holds transmission (BTDF), not reflection</source>
        <translation>enthält Transmission (BTDF), nicht Reflexion</translation>
    </message>
    <message>
        <source>the spectral content {0} is not known; Monochrome and XYZ are</source>
        <translation>der spektrale Inhalt {0} ist nicht bekannt; bekannt sind Monochrome und XYZ</translation>
    </message>
    <message>
        <source>the count of {0}</source>
        <translation>die Anzahl von {0}</translation>
    </message>
    <message>
        <source>expected 1 to {0} angles, not {1}</source>
        <translation>erwartet wurden 1 bis {0} Winkel, nicht {1}</translation>
    </message>
    <message>
        <source>the {0} angles of {1}</source>
        <translation>die {0} Winkel von {1}</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>ein Winkel</translation>
    </message>
    <message>
        <source>expected {0} angles, not {1}</source>
        <translation>erwartet wurden {0} Winkel, nicht {1}</translation>
    </message>
    <message>
        <source>an angle of {0} is beyond {1}°</source>
        <translation>ein Winkel von {0} liegt jenseits von {1}°</translation>
    </message>
    <message>
        <source>expected DataBegin</source>
        <translation>erwartet wurde DataBegin</translation>
    </message>
    <message>
        <source>expected TIS, not {0}</source>
        <translation>erwartet wurde TIS, nicht {0}</translation>
    </message>
    <message>
        <source>a row of values</source>
        <translation>eine Zeile mit Werten</translation>
    </message>
    <message>
        <source>expected {0} values, not {1}</source>
        <translation>erwartet wurden {0} Werte, nicht {1}</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>{0} would take {1}; {2} GiB is allowed ({3} can allow more)</source>
        <translation>{0}: nötig wäre {1}; erlaubt ist {2} GiB ({3} kann mehr erlauben)</translation>
    </message>
    <message>
        <source>{0} (given by a map)</source>
        <translation>{0} (durch eine Karte)</translation>
    </message>
    <message>
        <source>expected DataEnd</source>
        <translation>erwartet wurde DataEnd</translation>
    </message>
    <message>
        <source>Zemax BSDF text</source>
        <translation>Zemax-BSDF-Text</translation>
    </message>
    <message>
        <source>not a binary glTF file (it does not begin with the letters glTF)</source>
        <translation>keine binäre glTF-Datei (sie beginnt nicht mit den Buchstaben glTF)</translation>
    </message>
    <message>
        <source>binary glTF of version {0}; only version 2 can be read</source>
        <translation>binäres glTF der Version {0}; lesbar ist nur Version 2</translation>
    </message>
    <message>
        <source>cut short: {0} of {1} bytes are there</source>
        <translation>abgeschnitten: {0} von {1} Byte sind da</translation>
    </message>
    <message>
        <source>a chunk reaches past the end of the file</source>
        <translation>ein Abschnitt reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>{0}its JSON is damaged ({1})</source>
        <translation>{0}ihr JSON ist beschädigt ({1})</translation>
    </message>
    <message>
        <source>{0}its JSON is not an object</source>
        <translation>{0}ihr JSON ist kein Objekt</translation>
    </message>
    <message>
        <source>damaged mesh file ({0})</source>
        <translation>beschädigte Netzdatei ({0})</translation>
    </message>
    <message>
        <source>the triangles of all nodes</source>
        <translation>die Dreiecke aller Knoten</translation>
    </message>
    <message>
        <source>it requires the extension {0}, which is not read; export it again without</source>
        <translation>es verlangt die Erweiterung {0}, die nicht gelesen wird; exportieren Sie es neu ohne sie</translation>
    </message>
    <message>
        <source>not a list of objects</source>
        <translation>keine Liste von Objekten</translation>
    </message>
    <message>
        <source>a child that is not there</source>
        <translation>ein Kind, das es nicht gibt</translation>
    </message>
    <message>
        <source>a child of two nodes</source>
        <translation>ein Kind zweier Knoten</translation>
    </message>
    <message>
        <source>the scene graph runs in a circle</source>
        <translation>der Szenengraph läuft im Kreis</translation>
    </message>
    <message>
        <source>a scene names a node twice, or one that stands below another</source>
        <translation>eine Szene nennt einen Knoten zweimal, oder einen, der unter einem anderen steht</translation>
    </message>
    <message>
        <source>its place in the scene is not finite</source>
        <translation>seine Lage in der Szene ist nicht endlich</translation>
    </message>
    <message>
        <source>its matrix, translation, rotation or scale is damaged</source>
        <translation>seine Matrix, Verschiebung, Drehung oder Skalierung ist beschädigt</translation>
    </message>
    <message>
        <source>its points do not have three coordinates each</source>
        <translation>seine Punkte haben nicht je drei Koordinaten</translation>
    </message>
    <message>
        <source>its {0} values</source>
        <translation>seine {0} Werte</translation>
    </message>
    <message>
        <source>its {0} values are not in the file; {1} may be left out</source>
        <translation>seine {0} Werte sind nicht in der Datei; {1} kann ausgelassen sein</translation>
    </message>
    <message>
        <source>its values reach past the end of the file</source>
        <translation>seine Werte reichen über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>what its compressed views hold</source>
        <translation>was seine komprimierten Ansichten enthalten</translation>
    </message>
    <message>
        <source>its meshopt compression is damaged ({0})</source>
        <translation>seine meshopt-Kompression ist beschädigt ({0})</translation>
    </message>
    <message>
        <source>reaches past the end of the file</source>
        <translation>reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>{0} is {1}, which is no size or place</source>
        <translation>{0} ist {1}, was keine Größe oder Stelle ist</translation>
    </message>
    <message>
        <source>refers to {0}, which is not in its folder</source>
        <translation>verweist auf {0}, das nicht in seinem Ordner liegt</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>eine Blender-Datei</translation>
    </message>
    <message>
        <source>a Rhino file</source>
        <translation>eine Rhino-Datei</translation>
    </message>
    <message>
        <source>a JT file</source>
        <translation>eine JT-Datei</translation>
    </message>
    <message>
        <source>an AutoCAD drawing</source>
        <translation>eine AutoCAD-Zeichnung</translation>
    </message>
    <message>
        <source>a CATIA file</source>
        <translation>eine CATIA-Datei</translation>
    </message>
    <message>
        <source>a file of a CAD program</source>
        <translation>eine Datei eines CAD-Programms</translation>
    </message>
    <message>
        <source>{0}, which cannot be read</source>
        <translation>{0}, die nicht lesbar ist</translation>
    </message>
    <message>
        <source>of no kind of mesh that can be read</source>
        <translation>keine lesbare Art von Netz</translation>
    </message>
    <message>
        <source>{0}; export it as glTF, FBX, USD, STEP, OBJ, STL or PLY</source>
        <translation>{0}; exportieren Sie es als glTF, FBX, USD, STEP, OBJ, STL oder PLY</translation>
    </message>
    <message>
        <source>baked occlusion</source>
        <translation>berechnete Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>does not fit the mesh ({0})</source>
        <translation>passt nicht zum Netz ({0})</translation>
    </message>
    <message>
        <source>baked surfaces</source>
        <translation>berechnete Oberflächen</translation>
    </message>
    <message>
        <source>occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>no reason is given</source>
        <translation>ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>damaged, or of a kind that its library does not read ({0})</source>
        <translation>beschädigt, oder von einer Art, die seine Bibliothek nicht liest ({0})</translation>
    </message>
    <message>
        <source>its answer is damaged</source>
        <translation>seine Antwort ist beschädigt</translation>
    </message>
    <message>
        <source>a mesh with Draco compression</source>
        <translation>ein Netz mit Draco-Kompression</translation>
    </message>
    <message>
        <source>a USD file</source>
        <translation>eine USD-Datei</translation>
    </message>
    <message>
        <source>a file of this kind (FBX, Collada, 3MF, X3D, AC3D, 3DS)</source>
        <translation>eine Datei dieser Art (FBX, Collada, 3MF, X3D, AC3D, 3DS)</translation>
    </message>
    <message>
        <source>a file of CAD surfaces (STEP, IGES)</source>
        <translation>eine Datei mit CAD-Flächen (STEP, IGES)</translation>
    </message>
    <message>
        <source>glTF, OBJ, STL and PLY need nothing more</source>
        <translation>glTF, OBJ, STL und PLY brauchen nichts weiter</translation>
    </message>
    <message>
        <source>reading it takes more than {0} GiB of memory ({1} can allow more)</source>
        <translation>das Lesen braucht mehr als {0} GiB Speicher ({1} kann mehr erlauben)</translation>
    </message>
    <message>
        <source>reading it takes more than {0} s; make it smaller</source>
        <translation>das Lesen dauert länger als {0} s; verkleinern Sie es</translation>
    </message>
    <message>
        <source>no process could be started to read it ({0})</source>
        <translation>es ließ sich kein Prozess starten, um sie zu lesen ({0})</translation>
    </message>
    <message>
        <source>the library that reads it broke down: it is damaged, or {0}</source>
        <translation>die Bibliothek, die sie liest, ist abgestürzt: Sie ist beschädigt, oder {0}</translation>
    </message>
    <message>
        <source>its triangles</source>
        <translation>seine Dreiecke</translation>
    </message>
    <message>
        <source>its Draco compression is damaged</source>
        <translation>seine Draco-Kompression ist beschädigt</translation>
    </message>
    <message>
        <source>its Draco compression holds points, not triangles</source>
        <translation>seine Draco-Kompression enthält Punkte, keine Dreiecke</translation>
    </message>
    <message>
        <source>damaged, or without a surface or a body that triangles can be made of</source>
        <translation>beschädigt, oder ohne Fläche oder Körper, aus denen sich Dreiecke machen lassen</translation>
    </message>
    <message>
        <source>damaged: its surfaces could not be cut into triangles</source>
        <translation>beschädigt: Seine Flächen ließen sich nicht in Dreiecke zerlegen</translation>
    </message>
    <message>
        <source>damaged, or refers to files that are not there</source>
        <translation>beschädigt, oder verweist auf Dateien, die es nicht gibt</translation>
    </message>
    <message>
        <source>is cut off within its header of {0} bytes</source>
        <translation>ist in seinem Kopf von {0} Byte abgeschnitten</translation>
    </message>
    <message>
        <source>holds more than its triangles</source>
        <translation>enthält mehr als seine Dreiecke</translation>
    </message>
    <message>
        <source>its header promises {0} triangles, which take {1} bytes; it has {2}</source>
        <translation>sein Kopf kündigt {0} Dreiecke an, die {1} Byte einnehmen; es hat {2}</translation>
    </message>
    <message>
        <source>another file</source>
        <translation>eine andere Datei</translation>
    </message>
    <message>
        <source>needs {0} beside it, which cannot be read ({1})</source>
        <translation>braucht {0} daneben, das nicht lesbar ist ({1})</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>sie ist nicht da</translation>
    </message>
    <message>
        <source>damaged: it refers to data that it does not hold</source>
        <translation>beschädigt: Es verweist auf Daten, die es nicht enthält</translation>
    </message>
    <message>
        <source>damaged, or too large: there is not enough memory for what it announces</source>
        <translation>beschädigt oder zu groß: Für das, was es ankündigt, reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>damaged: it holds bytes that are no text where text belongs</source>
        <translation>beschädigt: Es enthält Bytes, die kein Text sind, wo Text hingehört</translation>
    </message>
    <message>
        <source>damaged, or not the kind of mesh that its name says</source>
        <translation>beschädigt, oder nicht die Art von Netz, die der Name angibt</translation>
    </message>
    <message>
        <source>node {0}</source>
        <translation>Knoten {0}</translation>
    </message>
    <message>
        <source>mesh {0}</source>
        <translation>Netz {0}</translation>
    </message>
    <message>
        <source>not glTF:</source>
        <translation>kein glTF:</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>holds no triangles (points or lines alone cannot be drawn)</source>
        <translation>enthält keine Dreiecke (Punkte oder Linien allein lassen sich nicht zeichnen)</translation>
    </message>
    <message>
        <source>taken as {0}</source>
        <translation>als {0} angenommen</translation>
    </message>
    <message>
        <source>taken as z up, which the file does not say</source>
        <translation>z als oben angenommen, was die Datei nicht angibt</translation>
    </message>
    <message>
        <source>no triangle that can be drawn ({0})</source>
        <translation>kein Dreieck, das sich zeichnen lässt ({0})</translation>
    </message>
    <message>
        <source>{0} m across as written, which no object is</source>
        <translation>{0} m groß wie geschrieben, was kein Gegenstand ist</translation>
    </message>
    <message>
        <source>{0}; taken as millimetres</source>
        <translation>{0}; als Millimeter angenommen</translation>
    </message>
    <message>
        <source>{0}; scaled by {1}</source>
        <translation>{0}; mit {1} skaliert</translation>
    </message>
    <message>
        <source>vn {0} {1} {2}</source>
        <translation>vn {0} {1} {2}</translation>
    </message>
    <message>
        <source>format binary_little_endian 1.0</source>
        <translation>Format binary_little_endian 1.0</translation>
    </message>
    <message>
        <source>comment {0}</source>
        <translation>Kommentar {0}</translation>
    </message>
    <message>
        <source>element vertex {0}</source>
        <translation>Element vertex {0}</translation>
    </message>
    <message>
        <source>property {0} {1}</source>
        <translation>Eigenschaft {0} {1}</translation>
    </message>
    <message>
        <source>element face {0}</source>
        <translation>Element face {0}</translation>
    </message>
    <message>
        <source>property list uchar int vertex_indices</source>
        <translation>Eigenschaft list uchar int vertex_indices</translation>
    </message>
    <message>
        <source>is both a value and a part</source>
        <translation>ist sowohl ein Wert als auch ein Teil</translation>
    </message>
    <message>
        <source>is no setting</source>
        <translation>ist keine Einstellung</translation>
    </message>
    <message>
        <source>the paint</source>
        <translation>der Lack</translation>
    </message>
    <message>
        <source>No palette format is called {0}; there are {1}.</source>
        <translation>Kein Palettenformat heißt {0}; es gibt {1}.</translation>
    </message>
    <message>
        <source>the ending {0} names no palette format that is written here ({1})</source>
        <translation>die Endung {0} nennt kein Palettenformat, das hier geschrieben wird ({1})</translation>
    </message>
    <message>
        <source>is of no palette format that is known here ({0})</source>
        <translation>hat kein hier bekanntes Palettenformat ({0})</translation>
    </message>
    <message>
        <source>the {0} file</source>
        <translation>die {0}-Datei</translation>
    </message>
    <message>
        <source>Lab identity built-in</source>
        <translation>Lab-Einheitsprofil, eingebaut</translation>
    </message>
    <message>
        <source>has no part {0}</source>
        <translation>hat keinen Teil {0}</translation>
    </message>
    <message>
        <source>A profile in the file {0}.</source>
        <translation>Ein Profil in der Datei {0}.</translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>in der Datei</translation>
    </message>
    <message>
        <source>{0} part of the file without colours is left out.</source>
        <translation>{0} Teil der Datei ohne Farben ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} parts of the file without colours are left out.</source>
        <translation>{0} Teile der Datei ohne Farben sind ausgelassen.</translation>
    </message>
    <message>
        <source>expected a whole number for {0}, not {1}</source>
        <translation>erwartet wurde eine ganze Zahl für {0}, nicht {1}</translation>
    </message>
    <message>
        <source>{0} entry without a colour of a known model is left out.</source>
        <translation>{0} Eintrag ohne Farbe eines bekannten Modells ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} entries without a colour of a known model are left out.</source>
        <translation>{0} Einträge ohne Farbe eines bekannten Modells sind ausgelassen.</translation>
    </message>
    <message>
        <source>Krita palette</source>
        <translation>Krita-Palette</translation>
    </message>
    <message>
        <source>Names in any script, codes, groups, columns, RGB, CMYK, Lab and Gray with every digit, their profiles, inks of their own, comments.</source>
        <translation>Namen in jeder Schrift, Codes, Gruppen, Spalten, RGB, CMYK, Lab und Grau mit allen Stellen, ihre Profile, eigene Druckfarben, Kommentare.</translation>
    </message>
    <message>
        <source>none first</source>
        <translation>ohne Gruppe zuerst</translation>
    </message>
    <message>
        <source>{0} parts of the file that are no colours (profiles) are left out.</source>
        <translation>{0} Teile der Datei, die keine Farben sind (Profile), sind ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours that the book does not show come at the end.</source>
        <translation>{0} Farben, die das Buch nicht zeigt, stehen am Ende.</translation>
    </message>
    <message>
        <source>{0} material of another kind (patterns, gradients) is left out.</source>
        <translation>{0} Material anderer Art (Muster, Verläufe) ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} materials of another kind (patterns, gradients) are left out.</source>
        <translation>{0} Materialien anderer Art (Muster, Verläufe) sind ausgelassen.</translation>
    </message>
    <message>
        <source>two materials are called {0}</source>
        <translation>zwei Materialien heißen {0}</translation>
    </message>
    <message>
        <source>{0} swatch of a material that is not in the file is left out.</source>
        <translation>{0} Muster eines Materials, das nicht in der Datei ist, ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} swatches of a material that is not in the file are left out.</source>
        <translation>{0} Muster eines Materials, das nicht in der Datei ist, sind ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colour without numbers in a known model is left out.</source>
        <translation>{0} Farbe ohne Zahlen in einem bekannten Modell ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours without numbers in a known model are left out.</source>
        <translation>{0} Farben ohne Zahlen in einem bekannten Modell sind ausgelassen.</translation>
    </message>
    <message>
        <source>{0} further number of a model that is not known is left out.</source>
        <translation>{0} weitere Zahl eines unbekannten Modells ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} further numbers of a model that is not known are left out.</source>
        <translation>{0} weitere Zahlen eines unbekannten Modells sind ausgelassen.</translation>
    </message>
    <message>
        <source>SwatchBooker swatch book</source>
        <translation>SwatchBooker-Musterbuch</translation>
    </message>
    <message>
        <source>Names in any script, codes, notes, groups within groups, several models for one colour with every digit, spot and global colours, columns.</source>
        <translation>Namen in jeder Schrift, Codes, Notizen, Gruppen in Gruppen, mehrere Modelle für eine Farbe mit allen Stellen, Sonder- und globale Farben, Spalten.</translation>
    </message>
    <message>
        <source>by groups</source>
        <translation>nach Gruppen</translation>
    </message>
    <message>
        <source>is packed by a method that palettes do not have ({0}); pack it by deflate</source>
        <translation>ist auf eine Weise gepackt, die Paletten nicht haben ({0}); packen Sie es mit Deflate</translation>
    </message>
    <message>
        <source>unpacks to more than the {0} bytes allowed</source>
        <translation>ergibt entpackt mehr als die erlaubten {0} Byte</translation>
    </message>
    <message>
        <source>is a damaged zip file ({0})</source>
        <translation>ist eine beschädigte ZIP-Datei ({0})</translation>
    </message>
    <message>
        <source>the signature</source>
        <translation>die Kennung</translation>
    </message>
    <message>
        <source>the number of the book</source>
        <translation>die Nummer des Buchs</translation>
    </message>
    <message>
        <source>version {0} is not known; 1 is</source>
        <translation>Version {0} ist nicht bekannt; bekannt ist 1</translation>
    </message>
    <message>
        <source>the title</source>
        <translation>der Titel</translation>
    </message>
    <message>
        <source>the prefix</source>
        <translation>die Vorsilbe</translation>
    </message>
    <message>
        <source>the postfix</source>
        <translation>die Nachsilbe</translation>
    </message>
    <message>
        <source>the description</source>
        <translation>die Beschreibung</translation>
    </message>
    <message>
        <source>the counts</source>
        <translation>die Anzahlen</translation>
    </message>
    <message>
        <source>the colour space {0} is not known; 0, 2 and 7 are</source>
        <translation>der Farbraum {0} ist nicht bekannt; bekannt sind 0, 2 und 7</translation>
    </message>
    <message>
        <source>{0} colours cannot lie in the {1} bytes that follow</source>
        <translation>{0} Farben passen nicht in die {1} folgenden Bytes</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>a code</source>
        <translation>ein Code</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>eine Farbe</translation>
    </message>
    <message>
        <source>the tail</source>
        <translation>das Ende</translation>
    </message>
    <message>
        <source>The bytes behind the last colour are skipped.</source>
        <translation>Die Bytes hinter der letzten Farbe werden übergangen.</translation>
    </message>
    <message>
        <source>{0} empty slot skipped.</source>
        <translation>{0} leerer Platz übergangen.</translation>
    </message>
    <message>
        <source>{0} empty slots skipped.</source>
        <translation>{0} leere Plätze übergangen.</translation>
    </message>
    <message>
        <source>Adobe colour book</source>
        <translation>Adobe-Farbbuch</translation>
    </message>
    <message>
        <source>Read only. Names, codes, RGB, CMYK or Lab in 8 bits, spot or process.</source>
        <translation>Nur lesen. Namen, Codes, RGB, CMYK oder Lab mit 8 Bit, Sonder- oder Prozessfarbe.</translation>
    </message>
    <message>
        <source>{0} bytes behind the last colour are skipped.</source>
        <translation>{0} Bytes hinter der letzten Farbe werden übergangen.</translation>
    </message>
    <message>
        <source>version {0} is not known; 1 and 2 are</source>
        <translation>Version {0} ist nicht bekannt; bekannt sind 1 und 2</translation>
    </message>
    <message>
        <source>the count of colours</source>
        <translation>die Anzahl der Farben</translation>
    </message>
    <message>
        <source>{0} colours of version {1} cannot lie in the {2} bytes that follow</source>
        <translation>{0} Farben der Version {1} passen nicht in die {2} folgenden Bytes</translation>
    </message>
    <message>
        <source>The colours of version 1 and 2 in the file differ; those of version 2 count.</source>
        <translation>Die Farben der Versionen 1 und 2 in der Datei weichen ab; es gelten die der Version 2.</translation>
    </message>
    <message>
        <source>the colour space {0} is a maker&apos;s own, without numbers that anyone else can read</source>
        <translation>der Farbraum {0} ist der eines Herstellers, ohne Zahlen, die andere lesen können</translation>
    </message>
    <message>
        <source>An ACO file holds 65,535 colours, and the palette has {0}.</source>
        <translation>Eine ACO-Datei fasst 65.535 Farben, und die Palette hat {0}.</translation>
    </message>
    <message>
        <source>Photoshop colour swatches</source>
        <translation>Photoshop-Farbmuster</translation>
    </message>
    <message>
        <source>Names in any script, RGB, HSB, CMYK, Lab and Gray in 16 bits; no groups.</source>
        <translation>Namen in jeder Schrift, RGB, HSB, CMYK, Lab und Grau mit 16 Bit; keine Gruppen.</translation>
    </message>
    <message>
        <source>has {0} bytes; a colour table has {1} or {2}</source>
        <translation>hat {0} Byte; eine Farbtabelle hat {1} oder {2}</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>die Tabelle</translation>
    </message>
    <message>
        <source>the transparent colour</source>
        <translation>die durchsichtige Farbe</translation>
    </message>
    <message>
        <source>{0} colours are more than the 256 of the table</source>
        <translation>{0} Farben sind mehr als die 256 der Tabelle</translation>
    </message>
    <message>
        <source>The colour {0} is marked as transparent, which a paint cannot be.</source>
        <translation>Die Farbe {0} ist als durchsichtig gekennzeichnet, was ein Lack nicht sein kann.</translation>
    </message>
    <message>
        <source>Photoshop colour table, or raw PAL</source>
        <translation>Photoshop-Farbtabelle, oder rohes PAL</translation>
    </message>
    <message>
        <source>Read only. sRGB in 8 bits, without names, 256 at most.</source>
        <translation>Nur lesen. sRGB mit 8 Bit, ohne Namen, höchstens 256.</translation>
    </message>
    <message>
        <source>is a colour list of an old kind (streamtyped); save it once more by a present macOS</source>
        <translation>ist eine Farbliste alter Art (streamtyped); speichern Sie sie noch einmal mit einem heutigen macOS</translation>
    </message>
    <message>
        <source>is nested too deep</source>
        <translation>ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>is no colour list of macOS ({0})</source>
        <translation>ist keine Farbliste von macOS ({0})</translation>
    </message>
    <message>
        <source>{0} colour without numbers (of the system, patterns) is left out.</source>
        <translation>{0} Farbe ohne Zahlen (des Systems, Muster) ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours without numbers (of the system, patterns) are left out.</source>
        <translation>{0} Farben ohne Zahlen (des Systems, Muster) sind ausgelassen.</translation>
    </message>
    <message>
        <source>The opacity of {0} colour is left out: a paint has none.</source>
        <translation>Die Deckkraft von {0} Farbe entfällt: Ein Lack hat keine.</translation>
    </message>
    <message>
        <source>The opacity of {0} colours is left out: a paint has none.</source>
        <translation>Die Deckkraft von {0} Farben entfällt: Ein Lack hat keine.</translation>
    </message>
    <message>
        <source>ends within the property list</source>
        <translation>endet in der Eigenschaftsliste</translation>
    </message>
    <message>
        <source>{0} objects cannot lie in it</source>
        <translation>{0} Objekte passen nicht hinein</translation>
    </message>
    <message>
        <source>Apple colour list</source>
        <translation>Apple-Farbliste</translation>
    </message>
    <message>
        <source>Read only. Names, RGB of several spaces, grey and CMYK.</source>
        <translation>Nur lesen. Namen, RGB mehrerer Räume, Grau und CMYK.</translation>
    </message>
    <message>
        <source>version {0}.{1} is not known; 1.0 is</source>
        <translation>Version {0}.{1} ist nicht bekannt; bekannt ist 1.0</translation>
    </message>
    <message>
        <source>the count of blocks</source>
        <translation>die Anzahl der Blöcke</translation>
    </message>
    <message>
        <source>{0} blocks cannot lie in the {1} bytes that follow</source>
        <translation>{0} Blöcke passen nicht in die {1} folgenden Bytes</translation>
    </message>
    <message>
        <source>the type of a block</source>
        <translation>der Typ eines Blocks</translation>
    </message>
    <message>
        <source>the length of a block</source>
        <translation>die Länge eines Blocks</translation>
    </message>
    <message>
        <source>a block of {0} bytes goes beyond the end of the file</source>
        <translation>ein Block von {0} Byte reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>{0} end of groups that never began skipped.</source>
        <translation>{0} Ende von Gruppen, die nie begannen, übergangen.</translation>
    </message>
    <message>
        <source>{0} ends of groups that never began skipped.</source>
        <translation>{0} Enden von Gruppen, die nie begannen, übergangen.</translation>
    </message>
    <message>
        <source>{0} block of a kind that is not known skipped.</source>
        <translation>{0} Block unbekannter Art übergangen.</translation>
    </message>
    <message>
        <source>{0} blocks of a kind that is not known skipped.</source>
        <translation>{0} Blöcke unbekannter Art übergangen.</translation>
    </message>
    <message>
        <source>{0} bytes behind the last block are skipped.</source>
        <translation>{0} Bytes hinter dem letzten Block werden übergangen.</translation>
    </message>
    <message>
        <source>the length of a name</source>
        <translation>die Länge eines Namens</translation>
    </message>
    <message>
        <source>the model of a colour</source>
        <translation>das Modell einer Farbe</translation>
    </message>
    <message>
        <source>the colour model {0} is not known</source>
        <translation>das Farbmodell {0} ist nicht bekannt</translation>
    </message>
    <message>
        <source>a colour in {0}</source>
        <translation>eine Farbe in {0}</translation>
    </message>
    <message>
        <source>the kind of a colour</source>
        <translation>die Art einer Farbe</translation>
    </message>
    <message>
        <source>{0} colour of a kind that is not known counts as a process colour.</source>
        <translation>{0} Farbe unbekannter Art gilt als Prozessfarbe.</translation>
    </message>
    <message>
        <source>{0} colours of a kind that is not known count as process colours.</source>
        <translation>{0} Farben unbekannter Art gelten als Prozessfarben.</translation>
    </message>
    <message>
        <source>Names in any script, groups, RGB, CMYK, Lab and Gray in 32-bit floats, global, spot and process colours.</source>
        <translation>Namen in jeder Schrift, Gruppen, RGB, CMYK, Lab und Grau als 32-Bit-Gleitkommazahlen, globale, Sonder- und Prozessfarben.</translation>
    </message>
    <message>
        <source>ends within {0}: expected {1} bytes, {2} are left</source>
        <translation>endet innerhalb von {0}: Erwartet wurden {1} Byte, übrig sind {2}</translation>
    </message>
    <message>
        <source>the length of {0}</source>
        <translation>die Länge von {0}</translation>
    </message>
    <message>
        <source>{0} of {1} characters goes beyond the end of the file</source>
        <translation>{0} von {1} Zeichen reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>7 wide</source>
        <translation>7 breit</translation>
    </message>
    <message>
        <source>12 inks</source>
        <translation>12 Druckfarben</translation>
    </message>
    <message>
        <source>X4 inks</source>
        <translation>X4-Druckfarben</translation>
    </message>
    <message>
        <source>does not begin as a CorelDRAW palette</source>
        <translation>beginnt nicht wie eine CorelDRAW-Palette</translation>
    </message>
    <message>
        <source>the palette&apos;s name</source>
        <translation>der Name der Palette</translation>
    </message>
    <message>
        <source>the count of headers</source>
        <translation>die Anzahl der Köpfe</translation>
    </message>
    <message>
        <source>expected 3 to 64 headers, not {0}</source>
        <translation>erwartet wurden 3 bis 64 Köpfe, nicht {0}</translation>
    </message>
    <message>
        <source>a header</source>
        <translation>ein Kopf</translation>
    </message>
    <message>
        <source>has no header {0}, or one beyond its end</source>
        <translation>hat keinen Kopf {0}, oder einen jenseits seines Endes</translation>
    </message>
    <message>
        <source>the kind of palette</source>
        <translation>die Art der Palette</translation>
    </message>
    <message>
        <source>the columns</source>
        <translation>die Spalten</translation>
    </message>
    <message>
        <source>a colour&apos;s place</source>
        <translation>der Platz einer Farbe</translation>
    </message>
    <message>
        <source>{0} colour in a model that is not known here (YIQ, Hexachrome, registration) skipped.</source>
        <translation>{0} Farbe in einem hier unbekannten Modell (YIQ, Hexachrome, Passer) übergangen.</translation>
    </message>
    <message>
        <source>{0} colours in a model that is not known here (YIQ, Hexachrome, registration) skipped.</source>
        <translation>{0} Farben in einem hier unbekannten Modell (YIQ, Hexachrome, Passer) übergangen.</translation>
    </message>
    <message>
        <source>A grey of 255 is taken for white, on which readers of this format disagree.</source>
        <translation>Ein Grau von 255 gilt als Weiß, worin sich Leser dieses Formats uneinig sind.</translation>
    </message>
    <message>
        <source>CorelDRAW palette (CPL)</source>
        <translation>CorelDRAW-Palette (CPL)</translation>
    </message>
    <message>
        <source>Read only. Names, numbers of inks, RGB, CMYK, Lab, HSB, HSL, CMY and grey in 8 bits, columns.</source>
        <translation>Nur lesen. Namen, Nummern der Druckfarben, RGB, CMYK, Lab, HSB, HSL, CMY und Grau mit 8 Bit, Spalten.</translation>
    </message>
    <message>
        <source>the length of the file</source>
        <translation>die Länge der Datei</translation>
    </message>
    <message>
        <source>{0} bytes are said to follow, {1} do</source>
        <translation>{0} Byte sollen folgen, {1} sind es</translation>
    </message>
    <message>
        <source>is a RIFF file, but holds no palette</source>
        <translation>ist eine RIFF-Datei, enthält aber keine Palette</translation>
    </message>
    <message>
        <source>the kind of a chunk</source>
        <translation>die Art eines Abschnitts</translation>
    </message>
    <message>
        <source>the length of a chunk</source>
        <translation>die Länge eines Abschnitts</translation>
    </message>
    <message>
        <source>a chunk of {0} bytes goes beyond the end of the file</source>
        <translation>ein Abschnitt von {0} Byte reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>{0} further part of the file skipped.</source>
        <translation>{0} weiterer Teil der Datei übergangen.</translation>
    </message>
    <message>
        <source>{0} further parts of the file skipped.</source>
        <translation>{0} weitere Teile der Datei übergangen.</translation>
    </message>
    <message>
        <source>ends without a chunk of colours</source>
        <translation>endet ohne einen Abschnitt mit Farben</translation>
    </message>
    <message>
        <source>the version and the count</source>
        <translation>die Version und die Anzahl</translation>
    </message>
    <message>
        <source>version {0} is not known; 0x0300 is</source>
        <translation>Version {0} ist nicht bekannt; bekannt ist 0x0300</translation>
    </message>
    <message>
        <source>{0} colours cannot lie in a chunk of {1} bytes</source>
        <translation>{0} Farben passen nicht in einen Abschnitt von {1} Byte</translation>
    </message>
    <message>
        <source>A RIFF palette holds 65,535 colours, and this one has {0}.</source>
        <translation>Eine RIFF-Palette fasst 65.535 Farben, und diese hat {0}.</translation>
    </message>
    <message>
        <source>Windows palette (RIFF)</source>
        <translation>Windows-Palette (RIFF)</translation>
    </message>
    <message>
        <source>sRGB in 8 bits, without names.</source>
        <translation>sRGB mit 8 Bit, ohne Namen.</translation>
    </message>
    <message>
        <source>is no ICC profile of a device in CMYK</source>
        <translation>ist kein ICC-Profil eines Geräts in CMYK</translation>
    </message>
    <message>
        <source>is no profile that can be used ({0})</source>
        <translation>ist kein brauchbares Profil ({0})</translation>
    </message>
    <message>
        <source>colour is</source>
        <translation>Farbe ist</translation>
    </message>
    <message>
        <source>colours are</source>
        <translation>Farben sind</translation>
    </message>
    <message>
        <source>{0} CMYK {1} shown through the profile {2}; the numbers of the inks are kept as they are.</source>
        <translation>{0} CMYK-{1} durch das Profil {2} gezeigt; die Zahlen der Druckfarben bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>{0} colours are more than the {1} that a file of this kind may have</source>
        <translation>{0} Farben sind mehr als die {1}, die eine Datei dieser Art haben darf</translation>
    </message>
    <message>
        <source>{0} name was cut: there were more than {1} characters.</source>
        <translation>{0} Name wurde gekürzt: Er hatte mehr als {1} Zeichen.</translation>
    </message>
    <message>
        <source>{0} names were cut: there were more than {1} characters.</source>
        <translation>{0} Namen wurden gekürzt: Sie hatten mehr als {1} Zeichen.</translation>
    </message>
    <message>
        <source>Control characters in {0} name became spaces.</source>
        <translation>Steuerzeichen in {0} Namen wurden zu Leerzeichen.</translation>
    </message>
    <message>
        <source>Control characters in {0} names became spaces.</source>
        <translation>Steuerzeichen in {0} Namen wurden zu Leerzeichen.</translation>
    </message>
    <message>
        <source>{0} text was cut: there were more than {1} characters.</source>
        <translation>{0} Text wurde gekürzt: Er hatte mehr als {1} Zeichen.</translation>
    </message>
    <message>
        <source>{0} texts were cut: there were more than {1} characters.</source>
        <translation>{0} Texte wurden gekürzt: Sie hatten mehr als {1} Zeichen.</translation>
    </message>
    <message>
        <source>groups are nested deeper than {0}</source>
        <translation>Gruppen sind tiefer als {0} verschachtelt</translation>
    </message>
    <message>
        <source>has more than {0} groups</source>
        <translation>hat mehr als {0} Gruppen</translation>
    </message>
    <message>
        <source>more than a thousand groups have the same name</source>
        <translation>mehr als tausend Gruppen haben denselben Namen</translation>
    </message>
    <message>
        <source>{0} group of a name that was there already has a number now.</source>
        <translation>{0} Gruppe mit einem schon vorhandenen Namen hat jetzt eine Nummer.</translation>
    </message>
    <message>
        <source>{0} groups of a name that was there already have a number now.</source>
        <translation>{0} Gruppen mit einem schon vorhandenen Namen haben jetzt eine Nummer.</translation>
    </message>
    <message>
        <source>is not text in UTF-16</source>
        <translation>ist kein Text in UTF-16</translation>
    </message>
    <message>
        <source>The file is not in UTF-8; its letters are taken for those of Latin-1 as Windows has it (1252).</source>
        <translation>Die Datei ist nicht in UTF-8; ihre Zeichen gelten als die von Latin-1, wie Windows es hat (1252).</translation>
    </message>
    <message>
        <source>BRDF Suite palette</source>
        <translation>BRDF-Suite-Palette</translation>
    </message>
    <message>
        <source>{0} is only read here; choose another format.</source>
        <translation>{0} wird hier nur gelesen; wählen Sie ein anderes Format.</translation>
    </message>
    <message>
        <source>{0} are too many for {1}: the file {2}. Write it in parts, or as a .brdfpalette.</source>
        <translation>{0} sind zu viele für {1}: Die Datei {2}. Schreiben Sie sie in Teilen oder als .brdfpalette.</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>The entries of each group stand together there.</source>
        <translation>Die Einträge jeder Gruppe stehen dort beisammen.</translation>
    </message>
    <message>
        <source>BRDF Suite opens no file of this kind with more than {0} colours, so it cannot read this one back.</source>
        <translation>BRDF Suite öffnet keine Datei dieser Art mit mehr als {0} Farben und kann diese daher nicht zurücklesen.</translation>
    </message>
    <message>
        <source>{0} left out.</source>
        <translation>{0} ausgelassen.</translation>
    </message>
    <message>
        <source>, computed without a profile</source>
        <translation>, ohne Profil berechnet</translation>
    </message>
    <message>
        <source>{0} in {1} {2} written as {3}{4}.</source>
        <translation>{0} in {1} {2} als {3} geschrieben{4}.</translation>
    </message>
    <message>
        <source>The palette&apos;s name is not stored; the file name is used.</source>
        <translation>Der Name der Palette wird nicht gespeichert; der Dateiname wird verwendet.</translation>
    </message>
    <message>
        <source>count of columns</source>
        <translation>Anzahl der Spalten</translation>
    </message>
    <message>
        <source>The palette&apos;s {0} are left out or changed.</source>
        <translation>Die Angaben der Palette ({0}) entfallen oder sind geändert.</translation>
    </message>
    <message>
        <source>The palette&apos;s {0} is left out or changed.</source>
        <translation>Die Angabe der Palette ({0}) entfällt oder ist geändert.</translation>
    </message>
    <message>
        <source>What another program&apos;s file said further of the palette is left out.</source>
        <translation>Was die Datei eines anderen Programms sonst noch über die Palette angab, entfällt.</translation>
    </message>
    <message>
        <source>{0} {1} left out.</source>
        <translation>{0} {1} ausgelassen.</translation>
    </message>
    <message>
        <source>empty group</source>
        <translation>leere Gruppe</translation>
    </message>
    <message>
        <source>The notes or colours of {0} are left out.</source>
        <translation>Die Notizen oder Farben von {0} entfallen.</translation>
    </message>
    <message>
        <source>{0} sample has fewer than three angles and became flat colours.</source>
        <translation>{0} Probe hat weniger als drei Winkel und wurde zu einzelnen Farben.</translation>
    </message>
    <message>
        <source>{0} samples have fewer than three angles and became flat colours.</source>
        <translation>{0} Proben haben weniger als drei Winkel und wurden zu einzelnen Farben.</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>ein Kommentar endet nicht</translation>
    </message>
    <message>
        <source>{0} custom property that is no colour known here skipped.</source>
        <translation>{0} eigene Eigenschaft, die keine hier bekannte Farbe ist, übergangen.</translation>
    </message>
    <message>
        <source>{0} custom properties that are no colours known here skipped.</source>
        <translation>{0} eigene Eigenschaften, die keine hier bekannten Farben sind, übergangen.</translation>
    </message>
    <message>
        <source>holds no custom property that is a colour</source>
        <translation>enthält keine eigene Eigenschaft, die eine Farbe ist</translation>
    </message>
    <message>
        <source>CSS custom properties</source>
        <translation>Eigene CSS-Eigenschaften</translation>
    </message>
    <message>
        <source>Names in any script, groups within groups, RGB of several spaces, HSL, CMYK, Lab, LCh and XYZ with every digit, notes of the palette.</source>
        <translation>Namen in jeder Schrift, Gruppen in Gruppen, RGB mehrerer Räume, HSL, CMYK, Lab, LCh und XYZ mit allen Stellen, Notizen der Palette.</translation>
    </message>
    <message>
        <source>the column {0} is there twice, or there are too many</source>
        <translation>die Spalte {0} kommt zweimal vor, oder es sind zu viele</translation>
    </message>
    <message>
        <source>has no column &apos;name&apos;, or none of readings as &apos;L_45&apos;</source>
        <translation>hat keine Spalte „name“, oder keine mit Messwerten wie „L_45“</translation>
    </message>
    <message>
        <source>The column {0} is none of a palette&apos;s and was skipped.</source>
        <translation>Die Spalte {0} gehört zu keiner Palette und wurde übergangen.</translation>
    </message>
    <message>
        <source>{0}, column usage</source>
        <translation>{0}, Spalte usage</translation>
    </message>
    <message>
        <source>In {0} row empty or repeated tags were left out.</source>
        <translation>In {0} Zeile wurden leere oder doppelte Schlagwörter ausgelassen.</translation>
    </message>
    <message>
        <source>In {0} rows empty or repeated tags were left out.</source>
        <translation>In {0} Zeilen wurden leere oder doppelte Schlagwörter ausgelassen.</translation>
    </message>
    <message>
        <source>{0}, column model</source>
        <translation>{0}, Spalte model</translation>
    </message>
    <message>
        <source>expected 2, 10 or nothing, not {0}</source>
        <translation>erwartet wurde 2, 10 oder nichts, nicht {0}</translation>
    </message>
    <message>
        <source>{0}, column observer_deg</source>
        <translation>{0}, Spalte observer_deg</translation>
    </message>
    <message>
        <source>has neither readings nor a model</source>
        <translation>hat weder Messwerte noch ein Modell</translation>
    </message>
    <message>
        <source>{0} row has fewer than three angles and became flat colours.</source>
        <translation>{0} Zeile hat weniger als drei Winkel und wurde zu einzelnen Farben.</translation>
    </message>
    <message>
        <source>{0} rows have fewer than three angles and became flat colours.</source>
        <translation>{0} Zeilen haben weniger als drei Winkel und wurden zu einzelnen Farben.</translation>
    </message>
    <message>
        <source>CSV table with angles</source>
        <translation>CSV-Tabelle mit Winkeln</translation>
    </message>
    <message>
        <source>Paints with L*a*b* at every angle (D65, 10°), gloss, flakes and settings; flat colours in every model; groups, codes, tags, usage, dates and notes.</source>
        <translation>Lacke mit L*a*b* bei jedem Winkel (D65, 10°), Glanz, Flakes und Einstellungen; einzelne Farben in jedem Modell; Gruppen, Codes, Schlagwörter, Verwendung, Daten und Notizen.</translation>
    </message>
    <message>
        <source>does not begin with {0}</source>
        <translation>beginnt nicht mit {0}</translation>
    </message>
    <message>
        <source>cannot be collected: {0}</source>
        <translation>kann nicht gesammelt werden: {0}</translation>
    </message>
    <message>
        <source>a file that it names cannot be collected: {0}</source>
        <translation>eine Datei, die darin genannt ist, kann nicht gesammelt werden: {0}</translation>
    </message>
    <message>
        <source>Values limited: {0}.</source>
        <translation>Werte begrenzt: {0}.</translation>
    </message>
    <message>
        <source>the line has more than {0} characters</source>
        <translation>die Zeile hat mehr als {0} Zeichen</translation>
    </message>
    <message>
        <source>The count of columns is none and was skipped.</source>
        <translation>Die Anzahl der Spalten ist keine und wurde übergangen.</translation>
    </message>
    <message>
        <source>expected three numbers and a name, not {0}</source>
        <translation>erwartet wurden drei Zahlen und ein Name, nicht {0}</translation>
    </message>
    <message>
        <source>{0} colour has numbers beyond 0 to 255, which were brought to its edge.</source>
        <translation>{0} Farbe hat Zahlen jenseits von 0 bis 255, die auf den Rand gebracht wurden.</translation>
    </message>
    <message>
        <source>{0} colours have numbers beyond 0 to 255, which were brought to its edge.</source>
        <translation>{0} Farben haben Zahlen jenseits von 0 bis 255, die auf den Rand gebracht wurden.</translation>
    </message>
    <message>
        <source>GIMP palette</source>
        <translation>GIMP-Palette</translation>
    </message>
    <message>
        <source>Names in any script, sRGB in 8 bits, columns, comments; no groups.</source>
        <translation>Namen in jeder Schrift, sRGB mit 8 Bit, Spalten, Kommentare; keine Gruppen.</translation>
    </message>
    <message>
        <source>expected a hex code as in #336699, alone or with a name, not {0}</source>
        <translation>erwartet wurde ein Hex-Code wie #336699, allein oder mit einem Namen, nicht {0}</translation>
    </message>
    <message>
        <source>holds no hex code</source>
        <translation>enthält keinen Hex-Code</translation>
    </message>
    <message>
        <source>{0} has eight digits, and nothing says whether the first or the last two are the opacity</source>
        <translation>{0} hat acht Ziffern, und nichts sagt, ob die ersten oder die letzten beiden die Deckkraft sind</translation>
    </message>
    <message>
        <source>the codes</source>
        <translation>die Codes</translation>
    </message>
    <message>
        <source>List of hex codes</source>
        <translation>Liste von Hex-Codes</translation>
    </message>
    <message>
        <source>sRGB in 8 bits, and names on the same line.</source>
        <translation>sRGB mit 8 Bit, und Namen in derselben Zeile.</translation>
    </message>
    <message>
        <source>expected version 0100</source>
        <translation>erwartet wurde Version 0100</translation>
    </message>
    <message>
        <source>expected a count of colours, not {0}</source>
        <translation>erwartet wurde eine Anzahl von Farben, nicht {0}</translation>
    </message>
    <message>
        <source>{0} line beyond the count that the file says skipped.</source>
        <translation>{0} Zeile jenseits der angegebenen Anzahl übergangen.</translation>
    </message>
    <message>
        <source>{0} lines beyond the count that the file says skipped.</source>
        <translation>{0} Zeilen jenseits der angegebenen Anzahl übergangen.</translation>
    </message>
    <message>
        <source>expected three numbers from 0 to 255, not {0}</source>
        <translation>erwartet wurden drei Zahlen von 0 bis 255, nicht {0}</translation>
    </message>
    <message>
        <source>{0} colours are said to follow, {1} do</source>
        <translation>{0} Farben sollen folgen, {1} sind es</translation>
    </message>
    <message>
        <source>Paint Shop Pro palette (JASC)</source>
        <translation>Paint-Shop-Pro-Palette (JASC)</translation>
    </message>
    <message>
        <source>is not JSON that can be read ({0})</source>
        <translation>ist kein lesbares JSON ({0})</translation>
    </message>
    <message>
        <source>holds no colour</source>
        <translation>enthält keine Farbe</translation>
    </message>
    <message>
        <source>is nested deeper than {0} groups</source>
        <translation>ist tiefer als {0} Gruppen verschachtelt</translation>
    </message>
    <message>
        <source>expected an object or a list</source>
        <translation>erwartet wurde ein Objekt oder eine Liste</translation>
    </message>
    <message>
        <source>{0} token that is no colour known here skipped.</source>
        <translation>{0} Token, das keine hier bekannte Farbe ist, übergangen.</translation>
    </message>
    <message>
        <source>{0} tokens that are no colours known here skipped.</source>
        <translation>{0} Token, die keine hier bekannten Farben sind, übergangen.</translation>
    </message>
    <message>
        <source>{0} value that is no colour skipped.</source>
        <translation>{0} Wert, der keine Farbe ist, übergangen.</translation>
    </message>
    <message>
        <source>{0} values that are no colours skipped.</source>
        <translation>{0} Werte, die keine Farben sind, übergangen.</translation>
    </message>
    <message>
        <source>{0} colour was changed by another program, and is flat now.</source>
        <translation>{0} Farbe wurde von einem anderen Programm geändert und ist jetzt eine einzelne Farbe.</translation>
    </message>
    <message>
        <source>{0} colours were changed by another program, and are flat now.</source>
        <translation>{0} Farben wurden von einem anderen Programm geändert und sind jetzt einzelne Farben.</translation>
    </message>
    <message>
        <source>JSON design tokens</source>
        <translation>JSON-Design-Token</translation>
    </message>
    <message>
        <source>Everything: for other programs names, groups and one colour, and all else as an extension of this program.</source>
        <translation>Alles: für andere Programme Namen, Gruppen und eine Farbe, und alles Übrige als Erweiterung dieses Programms.</translation>
    </message>
    <message>
        <source>{0} value that is no colour known here skipped.</source>
        <translation>{0} Wert, der keine hier bekannte Farbe ist, übergangen.</translation>
    </message>
    <message>
        <source>{0} values that are no colours known here skipped.</source>
        <translation>{0} Werte, die keine hier bekannten Farben sind, übergangen.</translation>
    </message>
    <message>
        <source>holds no variable that is a colour</source>
        <translation>enthält keine Variable, die eine Farbe ist</translation>
    </message>
    <message>
        <source>SCSS, Sass and LESS variables</source>
        <translation>SCSS-, Sass- und LESS-Variablen</translation>
    </message>
    <message>
        <source>Read only. Variables and maps of colours as CSS writes them, maps as groups.</source>
        <translation>Nur lesen. Variablen und Listen von Farben, wie CSS sie schreibt, Listen als Gruppen.</translation>
    </message>
    <message>
        <source>has no list of colours</source>
        <translation>hat keine Liste von Farben</translation>
    </message>
    <message>
        <source>{0} {1} are left out.</source>
        <translation>{0} {1} sind ausgelassen.</translation>
    </message>
    <message>
        <source>Sketch palette</source>
        <translation>Sketch-Palette</translation>
    </message>
    <message>
        <source>Names in any script, sRGB with every digit.</source>
        <translation>Namen in jeder Schrift, sRGB mit allen Stellen.</translation>
    </message>
    <message>
        <source>has the columns {0}; wanted are name (or none) and {1}</source>
        <translation>hat die Spalten {0}; verlangt sind name (oder keine) und {1}</translation>
    </message>
    <message>
        <source>holds no colour below its headings</source>
        <translation>enthält unter den Überschriften keine Farbe</translation>
    </message>
    <message>
        <source>The table has no headings; its columns were recognised by what is in them.</source>
        <translation>Die Tabelle hat keine Überschriften; ihre Spalten wurden an ihrem Inhalt erkannt.</translation>
    </message>
    <message>
        <source>{0} row without a colour was skipped.</source>
        <translation>{0} Zeile ohne Farbe wurde übergangen.</translation>
    </message>
    <message>
        <source>{0} rows without a colour were skipped.</source>
        <translation>{0} Zeilen ohne Farbe wurden übergangen.</translation>
    </message>
    <message>
        <source>the column {0} is there twice, and no heading says what each is</source>
        <translation>die Spalte {0} kommt zweimal vor, und keine Überschrift sagt, was jede ist</translation>
    </message>
    <message>
        <source>the header</source>
        <translation>der Kopf</translation>
    </message>
    <message>
        <source>X, Y and Z are taken for those of a white of 1.</source>
        <translation>X, Y und Z gelten als die eines Weiß von 1.</translation>
    </message>
    <message>
        <source>{0} has no number but 0 and 1; 1 is taken for full.</source>
        <translation>{0} hat keine Zahlen außer 0 und 1; 1 gilt als voll.</translation>
    </message>
    <message>
        <source>expected {0} numbers of {1}, not {2}</source>
        <translation>erwartet wurden {0} Zahlen von {1}, nicht {2}</translation>
    </message>
    <message>
        <source>expected {0} from 0 to {1}, not {2}</source>
        <translation>erwartet wurde {0} von 0 bis {1}, nicht {2}</translation>
    </message>
    <message>
        <source>The light {0} is not known here; its colours count as those of D50 and 2°.</source>
        <translation>Das Licht {0} ist hier nicht bekannt; seine Farben gelten als die von D50 und 2°.</translation>
    </message>
    <message>
        <source>{0} hex code had lost its zeros, as spreadsheets take them; they are put back.</source>
        <translation>{0} Hex-Code hatte seine Nullen verloren, wie Tabellenkalkulationen sie weglassen; sie sind ergänzt.</translation>
    </message>
    <message>
        <source>{0} hex codes had lost their zeros, as spreadsheets take them; they are put back.</source>
        <translation>{0} Hex-Codes hatten ihre Nullen verloren, wie Tabellenkalkulationen sie weglassen; sie sind ergänzt.</translation>
    </message>
    <message>
        <source>expected a hex code as in #336699, not {0}</source>
        <translation>erwartet wurde ein Hex-Code wie #336699, nicht {0}</translation>
    </message>
    <message>
        <source>Plain table (CSV, TSV)</source>
        <translation>Einfache Tabelle (CSV, TSV)</translation>
    </message>
    <message>
        <source>Read only. Names, codes, groups and notes; hex, RGB, L*a*b*, LCh, XYZ, CMYK, HSL, HSB, spectra; samples of instruments at several angles.</source>
        <translation>Nur lesen. Namen, Codes, Gruppen und Notizen; Hex, RGB, L*a*b*, LCh, XYZ, CMYK, HSL, HSB, Spektren; Proben von Messgeräten bei mehreren Winkeln.</translation>
    </message>
    <message>
        <source>{0} colour is encrypted by the book&apos;s maker, which only AutoCAD can read, and is left out.</source>
        <translation>{0} Farbe ist vom Hersteller des Buchs verschlüsselt, nur AutoCAD kann sie lesen; sie ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours are encrypted by the book&apos;s maker, which only AutoCAD can read, and are left out.</source>
        <translation>{0} Farben sind vom Hersteller des Buchs verschlüsselt, nur AutoCAD kann sie lesen; sie sind ausgelassen.</translation>
    </message>
    <message>
        <source>all of its colours are encrypted by the book&apos;s maker</source>
        <translation>alle Farben sind vom Hersteller des Buchs verschlüsselt</translation>
    </message>
    <message>
        <source>it has no colorEntry</source>
        <translation>es gibt kein colorEntry</translation>
    </message>
    <message>
        <source>holds no colour that can be read: {0}</source>
        <translation>enthält keine lesbare Farbe: {0}</translation>
    </message>
    <message>
        <source>{0} colour without numbers is left out.</source>
        <translation>{0} Farbe ohne Zahlen ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours without numbers are left out.</source>
        <translation>{0} Farben ohne Zahlen sind ausgelassen.</translation>
    </message>
    <message>
        <source>expected red, green and blue from 0 to 255</source>
        <translation>erwartet wurden Rot, Grün und Blau von 0 bis 255</translation>
    </message>
    <message>
        <source>AutoCAD colour book (XML)</source>
        <translation>AutoCAD-Farbbuch (XML)</translation>
    </message>
    <message>
        <source>Read only. Names, RGB in 8 bits; not the encrypted books of some makers.</source>
        <translation>Nur lesen. Namen, RGB mit 8 Bit; nicht die verschlüsselten Bücher einiger Hersteller.</translation>
    </message>
    <message>
        <source>{0} element that is no colour skipped.</source>
        <translation>{0} Element, das keine Farbe ist, übergangen.</translation>
    </message>
    <message>
        <source>{0} elements that are no colours skipped.</source>
        <translation>{0} Elemente, die keine Farben sind, übergangen.</translation>
    </message>
    <message>
        <source>{0} tint of inks is left out: only full inks have a colour here.</source>
        <translation>{0} Abtönung von Druckfarben ist ausgelassen: Nur volle Druckfarben haben hier eine Farbe.</translation>
    </message>
    <message>
        <source>{0} tints of inks are left out: only full inks have a colour here.</source>
        <translation>{0} Abtönungen von Druckfarben sind ausgelassen: Nur volle Druckfarben haben hier eine Farbe.</translation>
    </message>
    <message>
        <source>{0} colour in a model that is not known here is left out.</source>
        <translation>{0} Farbe in einem hier unbekannten Modell ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} colours in a model that is not known here are left out.</source>
        <translation>{0} Farben in einem hier unbekannten Modell sind ausgelassen.</translation>
    </message>
    <message>
        <source>expected {0} numbers of {1} in tints, not {2}</source>
        <translation>erwartet wurden {0} Zahlen von {1} in tints, nicht {2}</translation>
    </message>
    <message>
        <source>A grey of 1 is taken for white, on which readers of this format disagree.</source>
        <translation>Ein Grau von 1 gilt als Weiß, worin sich Leser dieses Formats uneinig sind.</translation>
    </message>
    <message>
        <source>CorelDRAW palette (XML)</source>
        <translation>CorelDRAW-Palette (XML)</translation>
    </message>
    <message>
        <source>Paints with L*a*b* at every angle, spectra, gloss and settings; flat colours in every model; groups, codes and tags as tags of this suite.</source>
        <translation>Lacke mit L*a*b* bei jedem Winkel, Spektren, Glanz und Einstellungen; einzelne Farben in jedem Modell; Gruppen, Codes und Schlagwörter als Marken dieser Suite.</translation>
    </message>
    <message>
        <source>The file holds no sample.</source>
        <translation>Die Datei enthält keine Probe.</translation>
    </message>
    <message>
        <source>{0}: the mean of up to {1} readings at an angle, which differ from it by at most ΔE00 {2}.</source>
        <translation>{0}: das Mittel aus bis zu {1} Messwerten je Winkel, die davon um höchstens ΔE00 {2} abweichen.</translation>
    </message>
    <message>
        <source>{0} sample without a value that can be used is left out.</source>
        <translation>{0} Probe ohne brauchbaren Wert ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} samples without a value that can be used are left out.</source>
        <translation>{0} Proben ohne brauchbaren Wert sind ausgelassen.</translation>
    </message>
    <message>
        <source>{0} sample says nothing of gloss, and as a paint gets 90 GU at 20°.</source>
        <translation>{0} Probe gibt keinen Glanz an und bekommt als Lack 90 GU bei 20°.</translation>
    </message>
    <message>
        <source>{0} samples say nothing of gloss, and as a paint gets 90 GU at 20°.</source>
        <translation>{0} Proben geben keinen Glanz an und bekommen als Lack 90 GU bei 20°.</translation>
    </message>
    <message>
        <source>{0} sample: L*a*b* is {1}.</source>
        <translation>{0} Probe: L*a*b* ist {1}.</translation>
    </message>
    <message>
        <source>{0} samples: L*a*b* is {1}.</source>
        <translation>{0} Proben: L*a*b* ist {1}.</translation>
    </message>
    <message>
        <source>{0} value that is of no reflectance is left out.</source>
        <translation>{0} Wert, der zu keiner Reflexion gehört, ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} values that are of no reflectance are left out.</source>
        <translation>{0} Werte, die zu keiner Reflexion gehören, sind ausgelassen.</translation>
    </message>
    <message>
        <source>MaxRange must be greater than 0</source>
        <translation>MaxRange muss größer als 0 sein</translation>
    </message>
    <message>
        <source>{0} spectrum without wavelengths is left out.</source>
        <translation>{0} Spektrum ohne Wellenlängen ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} spectra without wavelengths are left out.</source>
        <translation>{0} Spektren ohne Wellenlängen sind ausgelassen.</translation>
    </message>
    <message>
        <source>holds no element with a colour and an angle that are known here</source>
        <translation>enthält kein Element mit einer Farbe und einem Winkel, die hier bekannt sind</translation>
    </message>
    <message>
        <source>Instrument&apos;s or spreadsheet&apos;s XML</source>
        <translation>XML eines Messgeräts oder einer Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Read only. Names, L*a*b*, LCh, XYZ or spectra at several angles, gloss; sparkle and graininess as notes.</source>
        <translation>Nur lesen. Namen, L*a*b*, LCh, XYZ oder Spektren bei mehreren Winkeln, Glanz; Glitzern und Körnigkeit als Notizen.</translation>
    </message>
    <message>
        <source>{0} colour without some of its numbers; these are 0, as in Scribus.</source>
        <translation>{0} Farbe ohne einige ihrer Zahlen; diese sind 0, wie in Scribus.</translation>
    </message>
    <message>
        <source>{0} colours without some of their numbers; these are 0, as in Scribus.</source>
        <translation>{0} Farben ohne einige ihrer Zahlen; diese sind 0, wie in Scribus.</translation>
    </message>
    <message>
        <source>expected {0} bytes as in #{1} for {2}, not {3}</source>
        <translation>erwartet wurden {0} Byte wie in #{1} für {2}, nicht {3}</translation>
    </message>
    <message>
        <source>Scribus colours (XML)</source>
        <translation>Scribus-Farben (XML)</translation>
    </message>
    <message>
        <source>Names in any script, RGB, CMYK and Lab with every digit, inks of their own, registration marks.</source>
        <translation>Namen in jeder Schrift, RGB, CMYK und Lab mit allen Stellen, eigene Druckfarben, Passermarken.</translation>
    </message>
    <message>
        <source>expected a colour as in #336699, not {0}</source>
        <translation>erwartet wurde eine Farbe wie #336699, nicht {0}</translation>
    </message>
    <message>
        <source>LibreOffice colour table</source>
        <translation>LibreOffice-Farbtabelle</translation>
    </message>
    <message>
        <source>Names in any script, sRGB in 8 bits.</source>
        <translation>Namen in jeder Schrift, sRGB mit 8 Bit.</translation>
    </message>
    <message>
        <source>a paint needs readings at 3 angles at least, there are {0}</source>
        <translation>ein Lack braucht Messwerte bei mindestens 3 Winkeln, vorhanden sind {0}</translation>
    </message>
    <message>
        <source>Instrument&apos;s readings: {0}.</source>
        <translation>Messwerte des Geräts: {0}.</translation>
    </message>
    <message>
        <source>hex, or R G B, L a b, L C h, X Y Z, C M Y K, H S L or H S B, or L15 a15 b15 and so on for several angles, or wavelengths as 400 410 420</source>
        <translation>Hex, oder R G B, L a b, L C h, X Y Z, C M Y K, H S L oder H S B, oder L15 a15 b15 und so weiter für mehrere Winkel, oder Wellenlängen wie 400 410 420</translation>
    </message>
    <message>
        <source>has {0} cells under {1} headings; a decimal comma may have been taken for a separator</source>
        <translation>hat {0} Zellen unter {1} Überschriften; ein Dezimalkomma kann als Trennzeichen gegolten haben</translation>
    </message>
    <message>
        <source>the headings number readings {0}; wanted are angles, as 15, 25, 45</source>
        <translation>die Überschriften zählen Messwerte {0}; verlangt sind Winkel, wie 15, 25, 45</translation>
    </message>
    <message>
        <source>has more than {0} rows, or too many cells</source>
        <translation>hat mehr als {0} Zeilen, oder zu viele Zellen</translation>
    </message>
    <message>
        <source>is not a table that can be read ({0})</source>
        <translation>ist keine lesbare Tabelle ({0})</translation>
    </message>
    <message>
        <source>“{0}” is the mean of {1} measurements; {2}.</source>
        <translation>„{0}“ ist das Mittel aus {1} Messungen; {2}.</translation>
    </message>
    <message>
        <source>{0} names are those of several samples that differ by more than ΔE00 {1}; they stay apart.</source>
        <translation>{0} Namen gehören zu mehreren Proben, die um mehr als ΔE00 {1} abweichen; sie bleiben getrennt.</translation>
    </message>
    <message>
        <source>{0} more are left out</source>
        <translation>{0} weitere sind ausgelassen</translation>
    </message>
    <message>
        <source>they differ from it by at most ΔE00 {0}</source>
        <translation>sie weichen davon um höchstens ΔE00 {0} ab</translation>
    </message>
    <message>
        <source>Mean of {0} measurements; {1}.</source>
        <translation>Mittel aus {0} Messungen; {1}.</translation>
    </message>
    <message>
        <source>the column {0} is there twice, and no heading says at which angle</source>
        <translation>die Spalte {0} kommt zweimal vor, und keine Überschrift sagt, bei welchem Winkel</translation>
    </message>
    <message>
        <source>The layout of the table is not published; its columns were recognised by their headings.</source>
        <translation>Der Aufbau der Tabelle ist nicht veröffentlicht; ihre Spalten wurden an den Überschriften erkannt.</translation>
    </message>
    <message>
        <source>L*a*b* without a named light are taken for those of D65 and 10°.</source>
        <translation>L*a*b* ohne genanntes Licht gelten als die von D65 und 10°.</translation>
    </message>
    <message>
        <source>{0} readings: L*a*b* is recomputed from the spectrum.</source>
        <translation>{0} Messwerte: L*a*b* ist aus dem Spektrum neu berechnet.</translation>
    </message>
    <message>
        <source>The spectra are taken for per cent: their largest values could be no factors.</source>
        <translation>Die Spektren gelten als Prozentwerte: Ihre größten Werte könnten keine Faktoren sein.</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>und {0} weitere</translation>
    </message>
    <message>
        <source>Columns that are not known here were skipped: {0}{1}.</source>
        <translation>Hier unbekannte Spalten wurden übergangen: {0}{1}.</translation>
    </message>
    <message>
        <source>its spectra, of at most {0}, may be per cent or fractions, and nothing says which; write % into a heading, or give L* a* b* beside them</source>
        <translation>ihre Spektren, höchstens {0}, können Prozente oder Bruchteile sein, und nichts sagt, welche; schreiben Sie % in eine Überschrift, oder geben Sie L* a* b* daneben an</translation>
    </message>
    <message>
        <source>{0} is no angle in the plane of incidence</source>
        <translation>{0} ist kein Winkel in der Einfallsebene</translation>
    </message>
    <message>
        <source>gloss {0}</source>
        <translation>Glanz {0}</translation>
    </message>
    <message>
        <source>line {0}: {1}</source>
        <translation>Zeile {0}: {1}</translation>
    </message>
    <message>
        <source>the colour at {0}as{1} is left out: {2}</source>
        <translation>die Farbe bei {0}as{1} ist ausgelassen: {2}</translation>
    </message>
    <message>
        <source>{0}as{1} is out of the plane of incidence ({2}°)</source>
        <translation>{0}as{1} liegt außerhalb der Einfallsebene ({2}°)</translation>
    </message>
    <message>
        <source>L*a*b* of {0}as{1} are beyond what a paint can have</source>
        <translation>L*a*b* von {0}as{1} liegen jenseits dessen, was ein Lack haben kann</translation>
    </message>
    <message>
        <source>a spectrum with {0} in the place of a number is left out</source>
        <translation>ein Spektrum mit {0} anstelle einer Zahl ist ausgelassen</translation>
    </message>
    <message>
        <source>a spectrum with values beyond any reflectance is left out</source>
        <translation>ein Spektrum mit Werten jenseits jeder Reflexion ist ausgelassen</translation>
    </message>
    <message>
        <source>{0} stands in the place of a number</source>
        <translation>{0} steht anstelle einer Zahl</translation>
    </message>
    <message>
        <source>{0} and the {1}° observer</source>
        <translation>{0} und der {1}°-Beobachter</translation>
    </message>
    <message>
        <source>an unnamed light</source>
        <translation>ein ungenanntes Licht</translation>
    </message>
    <message>
        <source>has more than {0} readings, or too many fields</source>
        <translation>hat mehr als {0} Messwerte, oder zu viele Felder</translation>
    </message>
    <message>
        <source>{0}: the reflectance is negative or not finite at a sample of the fit.</source>
        <translation>{0}: Die Reflexion ist an einem Messpunkt der Anpassung negativ oder nicht endlich.</translation>
    </message>
    <message>
        <source>another paint of the database has the same file name</source>
        <translation>ein anderer Lack der Datenbank hat denselben Dateinamen</translation>
    </message>
    <message>
        <source>cannot be part of the database: {0}</source>
        <translation>kann nicht Teil der Datenbank sein: {0}</translation>
    </message>
    <message>
        <source>cannot be part of the database: nothing divides it into coat and base</source>
        <translation>kann nicht Teil der Datenbank sein: Nichts teilt ihn in Klarlack und Basis</translation>
    </message>
    <message>
        <source>{0}, edited</source>
        <translation>{0}, bearbeitet</translation>
    </message>
    <message>
        <source>there is no paint ({0}) in this folder</source>
        <translation>in diesem Ordner gibt es keinen Lack ({0})</translation>
    </message>
    <message>
        <source>this is no search of version {0}; remove it, or give --fresh</source>
        <translation>dies ist keine Suche der Version {0}; entfernen Sie sie, oder geben Sie --fresh an</translation>
    </message>
    <message>
        <source>this search is of other paints or other starts; remove it, or give --fresh</source>
        <translation>diese Suche gehört zu anderen Lacken oder anderen Anfängen; entfernen Sie sie, oder geben Sie --fresh an</translation>
    </message>
    <message>
        <source>the counts are not 1, 2, 3 …; remove it, or give --fresh</source>
        <translation>die Anzahlen sind nicht 1, 2, 3 …; entfernen Sie sie, oder geben Sie --fresh an</translation>
    </message>
    <message>
        <source>There is no basis of {0} lobes to be the default.</source>
        <translation>Es gibt keine Basis von {0} Keulen als Vorgabe.</translation>
    </message>
    <message>
        <source>expected {0} numbers</source>
        <translation>erwartet wurden {0} Zahlen</translation>
    </message>
    <message>
        <source>expected a number of at least 0</source>
        <translation>erwartet wurde eine Zahl von mindestens 0</translation>
    </message>
    <message>
        <source>{0} {1} or {2} {3}</source>
        <translation>{0} {1} oder {2} {3}</translation>
    </message>
    <message>
        <source>this is no search of lobes ({0})</source>
        <translation>dies ist keine Suche nach Keulen ({0})</translation>
    </message>
    <message>
        <source>expected a list of names</source>
        <translation>erwartet wurde eine Liste von Namen</translation>
    </message>
    <message>
        <source>the counts do not rise</source>
        <translation>die Anzahlen steigen nicht</translation>
    </message>
    <message>
        <source>there is no basis of {0} lobes</source>
        <translation>es gibt keine Basis von {0} Keulen</translation>
    </message>
    <message>
        <source>Lobe exponents must be finite and at least 1, not {0}.</source>
        <translation>Exponenten von Keulen müssen endlich und mindestens 1 sein, nicht {0}.</translation>
    </message>
    <message>
        <source>The linear program of a basis was not solved; the basis is left out.</source>
        <translation>Das lineare Programm einer Basis wurde nicht gelöst; die Basis ist ausgelassen.</translation>
    </message>
    <message>
        <source>A worker process of the search ended before its work was done (short of memory?). What is found is kept: run the command again.</source>
        <translation>Ein Arbeitsprozess der Suche endete, bevor seine Arbeit getan war (zu wenig Speicher?). Was gefunden ist, bleibt: Starten Sie den Befehl erneut.</translation>
    </message>
    <message>
        <source>The search takes from 1 to {0} lobes, not {1}.</source>
        <translation>Die Suche nimmt 1 bis {0} Keulen, nicht {1}.</translation>
    </message>
    <message>
        <source>The search needs at least 2 starts and 1 worker, not {0} and {1}.</source>
        <translation>Die Suche braucht mindestens 2 Anfänge und 1 Prozess, nicht {0} und {1}.</translation>
    </message>
    <message>
        <source>The database holds {0} paints</source>
        <translation>Die Datenbank enthält {0} Lacke</translation>
    </message>
    <message>
        <source>{0}; for {1} lobes it needs as many or more.</source>
        <translation>{0}; für {1} Keulen braucht es so viele oder mehr.</translation>
    </message>
    <message>
        <source>{0} lobes</source>
        <translation>{0} Keulen</translation>
    </message>
    <message>
        <source>{0} lobe</source>
        <translation>{0} Keule</translation>
    </message>
    <message>
        <source>with fewer than two there is nothing below it</source>
        <translation>mit weniger als zweien bleibt darunter nichts</translation>
    </message>
    <message>
        <source>A clearcoat counts as one of the lobes; {0}.</source>
        <translation>Ein Klarlack zählt als eine der Keulen; {0}.</translation>
    </message>
    <message>
        <source>one lobe</source>
        <translation>eine Keule</translation>
    </message>
    <message>
        <source>{0} values cannot determine the {1} parameters of {2}; measure more directions, or fit fewer lobes.</source>
        <translation>{0} Werte können die {1} Parameter von {2} nicht bestimmen; messen Sie mehr Richtungen, oder passen Sie weniger Keulen an.</translation>
    </message>
    <message>
        <source>{0} values cannot determine the {1} parameters of {2}; measure more directions.</source>
        <translation>{0} Werte können die {1} Parameter von {2} nicht bestimmen; messen Sie mehr Richtungen.</translation>
    </message>
    <message>
        <source>, or fit fewer lobes.</source>
        <translation>, oder passen Sie weniger Keulen an.</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>Anfänge</translation>
    </message>
    <message>
        <source>start {0} of {1}</source>
        <translation>Anfang {0} von {1}</translation>
    </message>
    <message>
        <source>refining</source>
        <translation>wird verfeinert</translation>
    </message>
    <message>
        <source>is no file of kept starts; name another one</source>
        <translation>ist keine Datei aufbewahrter Anfänge; nennen Sie eine andere</translation>
    </message>
    <message>
        <source>cannot be removed: {0}</source>
        <translation>lässt sich nicht entfernen: {0}</translation>
    </message>
    <message>
        <source>kd {0}</source>
        <translation>kd {0}</translation>
    </message>
    <message>
        <source>ks·r {0} {1}</source>
        <translation>ks·r {0} {1}</translation>
    </message>
    <message>
        <source>Lit at {0}° and beyond, the lobes send back up to {1} times the light: their rise towards grazing is more than a surface has.</source>
        <translation>Bei Beleuchtung aus {0}° und mehr werfen die Keulen bis zum {1}-Fachen des Lichts zurück: Ihr Anstieg zum streifenden Winkel ist größer als der einer Oberfläche.</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>{0} samples are left out: black, not finite, not weighted, or seen at more than {1}° from the normal.</source>
        <translation>{0} Messpunkte sind ausgelassen: schwarz, nicht endlich, ohne Gewicht oder aus mehr als {1}° von der Normalen gesehen.</translation>
    </message>
    <message>
        <source>{0} values of 0 or less have no logarithm and are left out.</source>
        <translation>{0} Werte von 0 oder weniger haben keinen Logarithmus und sind ausgelassen.</translation>
    </message>
    <message>
        <source>{0} % of the values are 0 or less: colours outside of the working space, or noise. To all, and to the fit, {1} % of the sample&apos;s brightest channel and {2} /sr are added before the logarithm.</source>
        <translation>{0} % der Werte sind 0 oder weniger: Farben außerhalb des Arbeitsfarbraums, oder Rauschen. Zu allen, und zur Anpassung, werden vor dem Logarithmus {1} % des hellsten Kanals des Messpunkts und {2} /sr addiert.</translation>
    </message>
    <message>
        <source>There is nothing in the {0} channel; its weights are 0.</source>
        <translation>Im Kanal {0} ist nichts; seine Gewichte sind 0.</translation>
    </message>
    <message>
        <source>the first has</source>
        <translation>die erste hat</translation>
    </message>
    <message>
        <source>the first {0} have</source>
        <translation>die ersten {0} haben</translation>
    </message>
    <message>
        <source>{0} as well as {1}; {2} no weight.</source>
        <translation>{0} ebenso wie {1}; {2} kein Gewicht.</translation>
    </message>
    <message>
        <source>The Fresnel reflectance of lobe {0} is not determined by these samples.</source>
        <translation>Der Fresnel-Reflexionsgrad der Keule {0} ist durch diese Messpunkte nicht bestimmt.</translation>
    </message>
    <message>
        <source>r is {0} ± {1}</source>
        <translation>r ist {0} ± {1}</translation>
    </message>
    <message>
        <source>Of lobe {0} only ks times r is known: {1}.</source>
        <translation>Von Keule {0} ist nur ks mal r bekannt: {1}.</translation>
    </message>
    <message>
        <source>Another answer fits as well within the noise: for lobe {0} it has m {1} and r {2} instead of {3} and {4}. The stated uncertainties cover both.</source>
        <translation>Eine andere Lösung passt innerhalb des Rauschens ebenso: Bei Keule {0} hat sie m {1} und r {2} statt {3} und {4}. Die angegebenen Unsicherheiten decken beide ab.</translation>
    </message>
    <message>
        <source>fit cook-torrance, or write a table</source>
        <translation>passen Sie Cook-Torrance an, oder schreiben Sie eine Tabelle</translation>
    </message>
    <message>
        <source>Lobes of the model {0} cannot be saved as a paint; {1}.</source>
        <translation>Keulen des Modells {0} lassen sich nicht als Lack speichern; {1}.</translation>
    </message>
    <message>
        <source>wi {0}, wo {1}, values {2}</source>
        <translation>wi {0}, wo {1}, Werte {2}</translation>
    </message>
    <message>
        <source>The samples do not fit together: {0}; expected (n, 3) of each.</source>
        <translation>Die Messpunkte passen nicht zusammen: {0}; erwartet wurde je (n, 3).</translation>
    </message>
    <message>
        <source>The weights must be {0} finite numbers, none negative.</source>
        <translation>Die Gewichte müssen {0} endliche Zahlen sein, keine negativ.</translation>
    </message>
    <message>
        <source>None of the {0} samples can be fitted: they are black, not finite, without weight, or seen at more than {1}° from the normal.</source>
        <translation>Keiner der {0} Messpunkte lässt sich anpassen: Sie sind schwarz, nicht endlich, ohne Gewicht oder aus mehr als {1}° von der Normalen gesehen.</translation>
    </message>
    <message>
        <source>The directions {0} have the shape {1}; expected (n, 3).</source>
        <translation>Die Richtungen {0} haben die Form {1}; erwartet wurde (n, 3).</translation>
    </message>
    <message>
        <source>The direction {0}[{1}] is not of unit length.</source>
        <translation>Die Richtung {0}[{1}] hat nicht die Länge 1.</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>{0}° is outside the range 10° to 90°</source>
        <translation>{0}° liegt außerhalb des Bereichs 10° bis 90°</translation>
    </message>
    <message>
        <source>expected a whole number from {0} to {1}, not {2}</source>
        <translation>erwartet wurde eine ganze Zahl von {0} bis {1}, nicht {2}</translation>
    </message>
    <message>
        <source>expected more than 1 time the body, not {0}</source>
        <translation>erwartet wurde mehr als das 1-Fache des Körpers, nicht {0}</translation>
    </message>
    <message>
        <source>expected 0 to {0}, not {1}</source>
        <translation>erwartet wurde 0 bis {0}, nicht {1}</translation>
    </message>
    <message>
        <source>expected more than 0 and at most 1, not {0}</source>
        <translation>erwartet wurde mehr als 0 und höchstens 1, nicht {0}</translation>
    </message>
    <message>
        <source>Every sample is 0: there is nothing to factor.</source>
        <translation>Jeder Messpunkt ist 0: Es gibt nichts zu faktorisieren.</translation>
    </message>
    <message>
        <source>The factorization has no finite answer; more smoothness may help.</source>
        <translation>Die Faktorisierung hat keine endliche Lösung; mehr Glättung kann helfen.</translation>
    </message>
    <message>
        <source>expected (n, 3) each, not {0}, {1}, {2}</source>
        <translation>erwartet wurde je (n, 3), nicht {0}, {1}, {2}</translation>
    </message>
    <message>
        <source>expected one finite number a sample, not negative</source>
        <translation>erwartet wurde eine endliche Zahl je Messpunkt, nicht negativ</translation>
    </message>
    <message>
        <source>No sample is finite and above the horizon: there is nothing to factor.</source>
        <translation>Kein Messpunkt ist endlich und über dem Horizont: Es gibt nichts zu faktorisieren.</translation>
    </message>
    <message>
        <source>one of {0} is wanted, not {1}</source>
        <translation>verlangt ist eines von {0}, nicht {1}</translation>
    </message>
    <message>
        <source>sampling</source>
        <translation>wird abgetastet</translation>
    </message>
    <message>
        <source>the name {0} is the peak&apos;s; give the map another</source>
        <translation>der Name {0} gehört der Spitze; geben Sie der Karte einen anderen</translation>
    </message>
    <message>
        <source>homomorphic factorization of {0}</source>
        <translation>homomorphe Faktorisierung von {0}</translation>
    </message>
    <message>
        <source>product of textures</source>
        <translation>Produkt von Texturen</translation>
    </message>
    <message>
        <source>a product of textures goes into a {0} or a {1}</source>
        <translation>ein Produkt von Texturen kommt in eine {0} oder eine {1}</translation>
    </message>
    <message>
        <source>expected 1 to {0}, not {1}</source>
        <translation>erwartet wurde 1 bis {0}, nicht {1}</translation>
    </message>
    <message>
        <source>cannot be written whole; the disk is full, or refuses it</source>
        <translation>lässt sich nicht vollständig schreiben; der Datenträger ist voll oder nimmt es nicht an</translation>
    </message>
    <message>
        <source>the textures of the paint cannot be read: it {0}</source>
        <translation>die Texturen des Lacks lassen sich nicht lesen: Die Datei {0}</translation>
    </message>
    <message>
        <source>expected the id {0}</source>
        <translation>erwartet wurde die Kennung {0}</translation>
    </message>
    <message>
        <source>cannot be collected: it {0}</source>
        <translation>lässt sich nicht einsammeln: Die Datei {0}</translation>
    </message>
    <message>
        <source>Arrow (pyarrow)</source>
        <translation>Arrow (pyarrow)</translation>
    </message>
    <message>
        <source>{0}: the sample is left out: {1} ({2})</source>
        <translation>{0}: die Probe ist ausgelassen: {1} ({2})</translation>
    </message>
    <message>
        <source>a reading is left out: {0} ({1})</source>
        <translation>ein Messwert ist ausgelassen: {0} ({1})</translation>
    </message>
    <message>
        <source>a colour is left out: {0} ({1})</source>
        <translation>eine Farbe ist ausgelassen: {0} ({1})</translation>
    </message>
    <message>
        <source>the values of a spectrum are beyond any reflectance factor; 1 is that of a perfect diffuser</source>
        <translation>die Werte eines Spektrums liegen außerhalb jedes Reflexionsfaktors; 1 ist der eines vollkommenen Streuers</translation>
    </message>
    <message>
        <source>The clearcoat is that of a designed paint with the same gloss.</source>
        <translation>Der Klarlack ist der eines entworfenen Lacks mit demselben Glanz.</translation>
    </message>
    <message>
        <source>In Blender, which evaluates the clearcoat otherwise, ΔE00 {0} on a sphere.</source>
        <translation>In Blender, das den Klarlack anders auswertet, ΔE00 {0} auf einer Kugel.</translation>
    </message>
    <message>
        <source>One colour, of a metal or a matt layer, and a roughness under a clearcoat, fitted on a sphere.</source>
        <translation>Eine Farbe, die eines Metalls oder einer matten Schicht, und eine Rauheit unter einem Klarlack, an eine Kugel angepasst.</translation>
    </message>
    <message>
        <source>is {0} × {1} pixels, too large to be read: at most {2} million pixels are</source>
        <translation>hat {0} × {1} Pixel, zu groß zum Lesen: höchstens {2} Millionen Pixel werden gelesen</translation>
    </message>
    <message>
        <source>holds numbers over {0}, which are neither shares nor directions</source>
        <translation>enthält Zahlen über {0}, die weder Anteile noch Richtungen sind</translation>
    </message>
    <message>
        <source>is a function that ALTA fitted ({0}), not data; export its samples from ALTA</source>
        <translation>ist eine von ALTA angepasste Funktion ({0}), keine Messdaten; exportieren Sie die Messpunkte aus ALTA</translation>
    </message>
    <message>
        <source>ALTA binary</source>
        <translation>ALTA, binär</translation>
    </message>
    <message>
        <source>holds no samples with light and view above the horizon</source>
        <translation>enthält keine Messwerte mit Licht und Blick über dem Horizont</translation>
    </message>
    <message>
        <source>{0} is {1}; {2} is known</source>
        <translation>{0} ist {1}; bekannt ist {2}</translation>
    </message>
    <message>
        <source>ENDIAN is {0}; expected little or big</source>
        <translation>ENDIAN ist {0}; erwartet wurde little oder big</translation>
    </message>
    <message>
        <source>SAMPLE_COUNT is {0}; expected 1 to {1}</source>
        <translation>SAMPLE_COUNT ist {0}; erwartet wurde 1 bis {1}</translation>
    </message>
    <message>
        <source>VS is {0}; expected 0, 1 or 2</source>
        <translation>VS ist {0}; erwartet wurde 0, 1 oder 2</translation>
    </message>
    <message>
        <source>is cut off: {0} rows of {1} numbers take {2} bytes</source>
        <translation>ist abgeschnitten: {0} Zeilen mit {1} Zahlen brauchen {2} Byte</translation>
    </message>
    <message>
        <source>holds more bytes than its rows take</source>
        <translation>enthält mehr Bytes, als seine Zeilen brauchen</translation>
    </message>
    <message>
        <source>{0} ({1}) gives no pair of directions above the surface</source>
        <translation>{0} ({1}) ergibt kein Paar von Richtungen über der Oberfläche</translation>
    </message>
    <message>
        <source>ALTA (text, binary)</source>
        <translation>ALTA (Text, binär)</translation>
    </message>
    <message>
        <source>the number of rows</source>
        <translation>die Anzahl der Zeilen</translation>
    </message>
    <message>
        <source>announces {0} values, more than the {1} allowed</source>
        <translation>kündigt {0} Werte an, mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>is cut off: {0} values are announced, at most {1} follow</source>
        <translation>ist abgeschnitten: {0} Werte sind angekündigt, höchstens {1} folgen</translation>
    </message>
    <message>
        <source>expected {0} that rise from 0 to at most {1}°</source>
        <translation>erwartet wurden {0}, die von 0 bis höchstens {1}° steigen</translation>
    </message>
    <message>
        <source>expected the root materialx, not {0}</source>
        <translation>erwartet wurde das Wurzelelement materialx, nicht {0}</translation>
    </message>
    <message>
        <source>The document holds {0} materials; “{1}” was read, not {2}.</source>
        <translation>Das Dokument enthält {0} Materialien; gelesen wurde „{1}“, nicht {2}.</translation>
    </message>
    <message>
        <source>the version {0} is none of MaterialX</source>
        <translation>die Version {0} ist keine von MaterialX</translation>
    </message>
    <message>
        <source>holds no surface shader that is known ({0}); found: {1}</source>
        <translation>enthält keinen bekannten Oberflächenshader ({0}); gefunden: {1}</translation>
    </message>
    <message>
        <source>the connections of an input go round, or are too deep</source>
        <translation>die Verbindungen eines Eingangs laufen im Kreis oder sind zu tief</translation>
    </message>
    <message>
        <source>a connection to nothing</source>
        <translation>eine Verbindung ins Leere</translation>
    </message>
    <message>
        <source>an interface without a value</source>
        <translation>eine Schnittstelle ohne Wert</translation>
    </message>
    <message>
        <source>{0} is {1}; expected {2} finite numbers</source>
        <translation>{0} ist {1}; erwartet wurden {2} endliche Zahlen</translation>
    </message>
    <message>
        <source>The colour space “{0}” is not known; its colours were taken as linear Rec. 709.</source>
        <translation>Der Farbraum „{0}“ ist nicht bekannt; seine Farben gelten als lineares Rec. 709.</translation>
    </message>
    <message>
        <source>Textures and computed inputs are not read; defaults stand for {0}.</source>
        <translation>Texturen und berechnete Eingänge werden nicht gelesen; Vorgaben gelten für {0}.</translation>
    </message>
    <message>
        <source>Left out: {0}.</source>
        <translation>Ausgelassen: {0}.</translation>
    </message>
    <message>
        <source>MaterialX surface shader</source>
        <translation>MaterialX-Oberflächenshader</translation>
    </message>
    <message>
        <source>holds transmission alone, no reflection</source>
        <translation>enthält nur Transmission, keine Reflexion</translation>
    </message>
    <message>
        <source>the file ends within the size of the table</source>
        <translation>die Datei endet innerhalb der Größe der Tabelle</translation>
    </message>
    <message>
        <source>kind {0}, {1} × {2} × {3} nodes are no table</source>
        <translation>Art {0} mit {1} × {2} × {3} Knoten ist keine Tabelle</translation>
    </message>
    <message>
        <source>holds more bytes than its table takes</source>
        <translation>enthält mehr Bytes, als seine Tabelle braucht</translation>
    </message>
    <message>
        <source>Left out: its transmission.</source>
        <translation>Ausgelassen: die Transmission.</translation>
    </message>
    <message>
        <source>cannot be written: the reflectance {0}</source>
        <translation>lässt sich nicht schreiben: Die Reflexion {0}</translation>
    </message>
    <message>
        <source>Tabulated every {0}°, as an isotropic reflectance; narrower highlights are widened.</source>
        <translation>Alle {0}° tabelliert, als isotrope Reflexion; schmalere Glanzlichter werden verbreitert.</translation>
    </message>
    <message>
        <source>cannot be written: the reflectance gives values that are not finite</source>
        <translation>lässt sich nicht schreiben: Die Reflexion ergibt Werte, die nicht endlich sind</translation>
    </message>
    <message>
        <source>{0} colours lie outside Rec. 709; their negative channel was written as 0.</source>
        <translation>{0} Farben liegen außerhalb von Rec. 709; ihr negativer Kanal wurde als 0 geschrieben.</translation>
    </message>
    <message>
        <source>it stores single precision</source>
        <translation>es speichert einfache Genauigkeit</translation>
    </message>
    <message>
        <source>it stores half precision</source>
        <translation>es speichert halbe Genauigkeit</translation>
    </message>
    <message>
        <source>the value of {0}</source>
        <translation>der Wert von {0}</translation>
    </message>
    <message>
        <source>{0} is {1}; expected one of {2}</source>
        <translation>{0} ist {1}; erwartet wurde eines von {2}</translation>
    </message>
    <message>
        <source>holds no reflection (BRDF) of the front side</source>
        <translation>enthält keine Reflexion (BRDF) der Vorderseite</translation>
    </message>
    <message>
        <source>several planes of incidence (POI); only isotropic files are read</source>
        <translation>mehrere Einfallsebenen (POI); gelesen werden nur isotrope Dateien</translation>
    </message>
    <message>
        <source>Left out: {0} blocks of transmission or of the back side.</source>
        <translation>Ausgelassen: {0} Blöcke der Transmission oder der Rückseite.</translation>
    </message>
    <message>
        <source>angles of incidence</source>
        <translation>Einfallswinkel</translation>
    </message>
    <message>
        <source>{0} blocks; {1} incidences of {2} channels are expected</source>
        <translation>{0} Blöcke; erwartet wurden {1} Einfälle mit {2} Kanälen</translation>
    </message>
    <message>
        <source>a block of the content XYZ has no TristimulusValue</source>
        <translation>ein Block mit dem Inhalt XYZ hat keinen TristimulusValue</translation>
    </message>
    <message>
        <source>a block is given twice</source>
        <translation>ein Block ist zweimal angegeben</translation>
    </message>
    <message>
        <source>radial angles</source>
        <translation>Radialwinkel</translation>
    </message>
    <message>
        <source>an angle of {0}</source>
        <translation>ein Winkel von {0}</translation>
    </message>
    <message>
        <source>expected a word of a block, not {0}</source>
        <translation>erwartet wurde ein Wort eines Blocks, nicht {0}</translation>
    </message>
    <message>
        <source>more than {0} blocks</source>
        <translation>mehr als {0} Blöcke</translation>
    </message>
    <message>
        <source>the last block has no values</source>
        <translation>der letzte Block hat keine Werte</translation>
    </message>
    <message>
        <source>LightTools BSDF text</source>
        <translation>LightTools-BSDF-Text</translation>
    </message>
    <message>
        <source>transmission (BTDF)</source>
        <translation>Transmission (BTDF)</translation>
    </message>
    <message>
        <source>the reflectance of a mirror direction alone (specular_reflectance)</source>
        <translation>Reflexionsgrad nur der Spiegelrichtung (specular_reflectance)</translation>
    </message>
    <message>
        <source>specular transmittance</source>
        <translation>gerichteter Transmissionsgrad</translation>
    </message>
    <message>
        <source>does not begin with VERSION</source>
        <translation>beginnt nicht mit VERSION</translation>
    </message>
    <message>
        <source>the block {0} is given twice</source>
        <translation>der Block {0} ist zweimal angegeben</translation>
    </message>
    <message>
        <source>no block</source>
        <translation>kein Block</translation>
    </message>
    <message>
        <source>holds no BRDF; it has {0}</source>
        <translation>enthält keine BRDF; vorhanden: {0}</translation>
    </message>
    <message>
        <source>the list of blocks</source>
        <translation>die Liste der Blöcke</translation>
    </message>
    <message>
        <source>expected an entry, not {0}</source>
        <translation>erwartet wurde ein Eintrag, nicht {0}</translation>
    </message>
    <message>
        <source>{0} is given twice</source>
        <translation>{0} ist zweimal angegeben</translation>
    </message>
    <message>
        <source>{0} is missing; expected one of {1}</source>
        <translation>{0} fehlt; erwartet wurde eines von {1}</translation>
    </message>
    <message>
        <source>{0} has {1} numbers; expected 1 to {2}</source>
        <translation>{0} hat {1} Zahlen; erwartet wurden 1 bis {2}</translation>
    </message>
    <message>
        <source>an entry of {0}</source>
        <translation>ein Eintrag von {0}</translation>
    </message>
    <message>
        <source>the colour model spectrum needs WAVELENGTH_LIST</source>
        <translation>das Farbmodell spectrum braucht WAVELENGTH_LIST</translation>
    </message>
    <message>
        <source>{0} is missing</source>
        <translation>{0} fehlt</translation>
    </message>
    <message>
        <source>angles of {0}</source>
        <translation>Winkel von {0}</translation>
    </message>
    <message>
        <source>the reduction {0} is not known</source>
        <translation>die Reduktion {0} ist nicht bekannt</translation>
    </message>
    <message>
        <source>reciprocity is a reduction of the half-difference system alone</source>
        <translation>Reziprozität ist nur im System der Halb- und Differenzwinkel eine Reduktion</translation>
    </message>
    <message>
        <source>bilateral symmetry of an anisotropic table in the spherical system is ambiguous</source>
        <translation>bilaterale Symmetrie einer anisotropen Tabelle im sphärischen System ist mehrdeutig</translation>
    </message>
    <message>
        <source>with the reduction {0} angles reach at most {1}°</source>
        <translation>mit der Reduktion {0} reichen die Winkel bis höchstens {1}°</translation>
    </message>
    <message>
        <source>PARAM4_LIST wants the specular system, and as many offsets as PARAM0_LIST has angles</source>
        <translation>PARAM4_LIST verlangt das System der Spiegelrichtung und so viele Versätze, wie PARAM0_LIST Winkel hat</translation>
    </message>
    <message>
        <source>an offset is beyond 90°</source>
        <translation>ein Versatz liegt jenseits von 90°</translation>
    </message>
    <message>
        <source>has more than {0} blocks</source>
        <translation>hat mehr als {0} Blöcke</translation>
    </message>
    <message>
        <source>more than {0} entries before {1}</source>
        <translation>mehr als {0} Einträge vor {1}</translation>
    </message>
    <message>
        <source>the file ends after {0} of {1} colours</source>
        <translation>die Datei endet nach {0} von {1} Farben</translation>
    </message>
    <message>
        <source>SSDD (surface scattering distribution data)</source>
        <translation>SSDD (surface scattering distribution data)</translation>
    </message>
    <message>
        <source>the field &apos;wvls&apos;</source>
        <translation>das Feld „wvls“</translation>
    </message>
    <message>
        <source>expected the shape {0}, not {1}</source>
        <translation>erwartet wurde die Form {0}, nicht {1}</translation>
    </message>
    <message>
        <source>the field &apos;M&apos;</source>
        <translation>das Feld „M“</translation>
    </message>
    <message>
        <source>polarimetric BRDF (pBSDF)</source>
        <translation>polarimetrische BRDF (pBSDF)</translation>
    </message>
    <message>
        <source>The polarization was left out; the reflectance is that of unpolarized light.</source>
        <translation>Die Polarisation ist ausgelassen; die Reflexion ist die von unpolarisiertem Licht.</translation>
    </message>
    <message>
        <source>{0} of {1} dimensions</source>
        <translation>{0} mit {1} Dimensionen</translation>
    </message>
    <message>
        <source>expected {0}, not {1} of the shape {2}</source>
        <translation>erwartet wurde {0}, nicht {1} der Form {2}</translation>
    </message>
    <message>
        <source>expected the shape (1, n), not {0}</source>
        <translation>erwartet wurde die Form (1, n), nicht {0}</translation>
    </message>
    <message>
        <source>expected angles that rise within {0} to {1}</source>
        <translation>erwartet wurden Winkel, die innerhalb von {0} bis {1} steigen</translation>
    </message>
    <message>
        <source>holds NaN alone</source>
        <translation>enthält nur NaN</translation>
    </message>
    <message>
        <source>Polarimetric BRDF (intensity)</source>
        <translation>Polarimetrische BRDF (Intensität)</translation>
    </message>
    <message>
        <source>needs {0} beside it, which {1}</source>
        <translation>braucht {0} daneben; diese Datei {1}</translation>
    </message>
    <message>
        <source>damaged: a node names a mesh that is not there</source>
        <translation>beschädigt: ein Knoten nennt ein Netz, das nicht vorhanden ist</translation>
    </message>
    <message>
        <source>damaged ({0})</source>
        <translation>beschädigt ({0})</translation>
    </message>
    <message>
        <source>refers to more than {0} other files</source>
        <translation>verweist auf mehr als {0} andere Dateien</translation>
    </message>
    <message>
        <source>is no material library in the folder of the mesh</source>
        <translation>ist keine Materialbibliothek im Ordner des Netzes</translation>
    </message>
    <message>
        <source>The numbers before the codes are taken for names.</source>
        <translation>Die Nummern vor den Codes gelten als Namen.</translation>
    </message>
    <message>
        <source>has more than {0} variables</source>
        <translation>hat mehr als {0} Variablen</translation>
    </message>
    <message>
        <source>{0} variable without effect, since it is set elsewhere, is left out.</source>
        <translation>{0} Variable ohne Wirkung, da sie anderswo gesetzt wird, ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} variables without effect, since they are set elsewhere, are left out.</source>
        <translation>{0} Variablen ohne Wirkung, da sie anderswo gesetzt werden, sind ausgelassen.</translation>
    </message>
    <message>
        <source>expected red, green and blue as numbers, or a hex code</source>
        <translation>erwartet wurden Rot, Grün und Blau als Zahlen oder ein Hex-Code</translation>
    </message>
    <message>
        <source>No L* is above 1, which is nearly black; Oklab, and L from 0 to 1, are not known from CIELAB here.</source>
        <translation>Kein L* liegt über 1, das ist fast Schwarz; Oklab und L von 0 bis 1 sind hier nicht von CIELAB zu unterscheiden.</translation>
    </message>
    <message>
        <source>No number of {0} is above 1; hues are taken for shares of the circle.</source>
        <translation>Keine Zahl in {0} liegt über 1; Farbtöne gelten als Anteile des Kreises.</translation>
    </message>
    <message>
        <source>{0} hex code of three digits is taken for a short one, as #369 for #336699, and not for a number that has lost its zeros.</source>
        <translation>{0} Hex-Code aus drei Ziffern gilt als Kurzform, wie #369 für #336699, und nicht als Zahl, die ihre Nullen verloren hat.</translation>
    </message>
    <message>
        <source>{0} hex codes of three digits are taken for short ones, as #369 for #336699, and not for numbers that have lost their zeros.</source>
        <translation>{0} Hex-Codes aus drei Ziffern gelten als Kurzformen, wie #369 für #336699, und nicht als Zahlen, die ihre Nullen verloren haben.</translation>
    </message>
    <message>
        <source>Read only. Names, RGB, CMYK, Lab, grey, HSB and HLS, inks with their values in several models.</source>
        <translation>Nur lesen. Namen, RGB, CMYK, Lab, Grau, HSB und HLS, Druckfarben mit ihren Werten in mehreren Modellen.</translation>
    </message>
    <message>
        <source>The sample {0} is left out: {1} ({2}).</source>
        <translation>Die Probe {0} ist ausgelassen: {1} ({2}).</translation>
    </message>
    <message>
        <source>{0} more sample is left out.</source>
        <translation>{0} weitere Probe ist ausgelassen.</translation>
    </message>
    <message>
        <source>{0} more samples are left out.</source>
        <translation>{0} weitere Proben sind ausgelassen.</translation>
    </message>
    <message>
        <source>A value of {0} is left out: {1} ({2}).</source>
        <translation>Ein Wert von {0} ist ausgelassen: {1} ({2}).</translation>
    </message>
    <message>
        <source>holds no colour in RGB, CMYK or Lab</source>
        <translation>enthält keine Farbe in RGB, CMYK oder Lab</translation>
    </message>
    <message>
        <source>{0} is a difference, tolerance or statistic, no measurement</source>
        <translation>{0} ist eine Differenz, Toleranz oder Statistik, kein Messwert</translation>
    </message>
    <message>
        <source>Elements of differences, tolerances or statistics are left out: {0}.</source>
        <translation>Ausgelassene Elemente mit Differenzen, Toleranzen oder Statistiken: {0}.</translation>
    </message>
    <message>
        <source>is an AxF material or another HDF5 container, which is not read; export its measurements as CxF3 (see the page “AxF” of the manual)</source>
        <translation>ist ein AxF-Material oder ein anderer HDF5-Container und wird nicht gelesen; exportieren Sie die Messwerte als CxF3 (siehe die Seite „AxF“ des Handbuchs)</translation>
    </message>
    <message>
        <source>is a desktop theme or a colour scheme of windows (settings in sections), which is not read; write its colours as hex codes, one a line</source>
        <translation>ist ein Desktop-Thema oder ein Farbschema von Fenstern (Einstellungen in Abschnitten) und wird nicht gelesen; schreiben Sie die Farben als Hex-Codes, einen je Zeile</translation>
    </message>
    <message>
        <source>expected {0} to {1} texels, not {2}</source>
        <translation>erwartet wurden {0} bis {1} Texel, nicht {2}</translation>
    </message>
    <message>
        <source>normal equations</source>
        <translation>Normalgleichungen</translation>
    </message>
    <message>
        <source>Cholesky factor</source>
        <translation>Cholesky-Faktor</translation>
    </message>
    <message>
        <source>least squares by iteration</source>
        <translation>kleinste Quadrate durch Iteration</translation>
    </message>
    <message>
        <source>Give the base&apos;s aspecular angles and their weights together.</source>
        <translation>Geben Sie die Aspekularwinkel der Basis und ihre Gewichte zusammen an.</translation>
    </message>
    <message>
        <source>The smoothness over the angles is {0}; it must be 0 or more.</source>
        <translation>Die Glättung über den Winkeln ist {0}; sie muss 0 oder mehr sein.</translation>
    </message>
    <message>
        <source>The system of one incidence holds a negative or not finite entry.</source>
        <translation>Das Gleichungssystem eines Einfalls enthält einen negativen oder nicht endlichen Eintrag.</translation>
    </message>
    <message>
        <source>at the aspecular angle {0}° under light at {1}°</source>
        <translation>beim Aspekularwinkel {0}° unter Licht bei {1}°</translation>
    </message>
    <message>
        <source>at least {0} angles of incidence and takes at most {1}</source>
        <translation>mindestens {0} Einfallswinkel und höchstens {1}</translation>
    </message>
    <message>
        <source>A fit at several angles needs {0}, not {1}.</source>
        <translation>Eine Anpassung bei mehreren Winkeln braucht {0}, nicht {1}.</translation>
    </message>
    <message>
        <source>The power of the angles&apos; placement is {0}; it must be more than 0.</source>
        <translation>Die Potenz der Verteilung der Winkel ist {0}; sie muss mehr als 0 sein.</translation>
    </message>
    <message>
        <source>The smallest cosine of incidence is {0}; it must lie between 0 and cos 45°.</source>
        <translation>Der kleinste Kosinus des Einfalls ist {0}; er muss zwischen 0 und cos 45° liegen.</translation>
    </message>
    <message>
        <source>The {0} of a fit have shapes {1}, not {2}.</source>
        <translation>{0} einer Anpassung haben die Formen {1}, nicht {2}.</translation>
    </message>
    <message>
        <source>The target of a fit is not finite, or so large that its sum is not; scale it down.</source>
        <translation>Das Ziel einer Anpassung ist nicht endlich, oder so groß, dass seine Summe es nicht ist; verkleinern Sie es.</translation>
    </message>
    <message>
        <source>A factor on a sample&apos;s weight is not a positive finite number.</source>
        <translation>Ein Faktor auf das Gewicht eines Messpunkts ist keine positive endliche Zahl.</translation>
    </message>
    <message>
        <source>The linear-programming solver found no optimum for these samples.</source>
        <translation>Der Löser der linearen Optimierung fand für diese Messpunkte kein Optimum.</translation>
    </message>
    <message>
        <source>The lobe basis is empty; give at least one exponent.</source>
        <translation>Die Keulenbasis ist leer; geben Sie mindestens einen Exponenten an.</translation>
    </message>
    <message>
        <source>The lobe exponent {0} is not a finite number of at least 1.</source>
        <translation>Der Exponent {0} einer Keule ist keine endliche Zahl von mindestens 1.</translation>
    </message>
    <message>
        <source>{0} follows {1}</source>
        <translation>{0} folgt auf {1}</translation>
    </message>
    <message>
        <source>The lobe exponents must ascend without repeats, but {0}.</source>
        <translation>Die Exponenten der Keulen müssen ohne Wiederholung steigen, aber {0}.</translation>
    </message>
    <message>
        <source>A lobe basis needs at least one lobe, not {0}.</source>
        <translation>Eine Keulenbasis braucht mindestens eine Keule, nicht {0}.</translation>
    </message>
    <message>
        <source>Exponents from {0} to {1} do not ascend from at least 1.</source>
        <translation>Exponenten von {0} bis {1} steigen nicht ab mindestens 1.</translation>
    </message>
    <message>
        <source>this is no {0} of version {1}</source>
        <translation>dies ist kein {0} der Version {1}</translation>
    </message>
    <message>
        <source>expected a list of numbers</source>
        <translation>erwartet wurde eine Liste von Zahlen</translation>
    </message>
    <message>
        <source>there is no basis of {0} lobes; it has those of {1}</source>
        <translation>es gibt keine Basis von {0} Keulen; es gibt die von {1}</translation>
    </message>
    <message>
        <source>at most {0} lobes are drawn, not {1}</source>
        <translation>höchstens {0} Keulen werden gezeichnet, nicht {1}</translation>
    </message>
    <message>
        <source>{0} has samples of shape {1}, not {2}.</source>
        <translation>{0} hat Messpunkte der Form {1}, nicht {2}.</translation>
    </message>
    <message>
        <source>is not finite</source>
        <translation>ist nicht endlich</translation>
    </message>
    <message>
        <source>is negative ({0} 1/sr)</source>
        <translation>ist negativ ({0} 1/sr)</translation>
    </message>
    <message>
        <source>is beyond any reflectance ({0} 1/sr)</source>
        <translation>liegt jenseits jeder Reflexion ({0} 1/sr)</translation>
    </message>
    <message>
        <source>beyond any reflectance</source>
        <translation>jenseits jeder Reflexion</translation>
    </message>
    <message>
        <source>{0} channel {1} {2}</source>
        <translation>{0} Kanal {1} {2}</translation>
    </message>
    <message>
        <source>{0} cannot be fitted: its {1}.</source>
        <translation>{0} lässt sich nicht anpassen: {1}.</translation>
    </message>
    <message>
        <source>The time limit of a fit is {0} s; it must be more than 0.</source>
        <translation>Das Zeitlimit einer Anpassung ist {0} s; es muss mehr als 0 sein.</translation>
    </message>
    <message>
        <source>The refractive index of the coat is {0}; it must be 1 or more.</source>
        <translation>Die Brechzahl des Klarlacks ist {0}; sie muss 1 oder mehr sein.</translation>
    </message>
    <message>
        <source>The base has no sample at {0} to read the diffuse term from.</source>
        <translation>Die Basis hat keinen Messpunkt bei {0}, von dem sich der diffuse Anteil ablesen ließe.</translation>
    </message>
    <message>
        <source>The base</source>
        <translation>Die Basis</translation>
    </message>
    <message>
        <source>The coat</source>
        <translation>Der Klarlack</translation>
    </message>
    <message>
        <source>at the aspecular angle {0}°</source>
        <translation>beim Aspekularwinkel {0}°</translation>
    </message>
    <message>
        <source>option {0}</source>
        <translation>Option {0}</translation>
    </message>
    <message>
        <source>The linear-programming solver refused its {0}.</source>
        <translation>Der Löser der linearen Optimierung wies {0} zurück.</translation>
    </message>
    <message>
        <source>There is nothing to fit: no sample has light and view above the horizon.</source>
        <translation>Es gibt nichts anzupassen: Kein Messpunkt hat Licht und Blick über dem Horizont.</translation>
    </message>
    <message>
        <source>the view {0}° from its mirror direction</source>
        <translation>der Blick {0}° von seiner Spiegelrichtung</translation>
    </message>
    <message>
        <source>with the light at {0}° from the normal and {1}</source>
        <translation>mit dem Licht bei {0}° von der Normalen und {1}</translation>
    </message>
    <message>
        <source>The reflectance</source>
        <translation>Die Reflexion</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>wird angepasst</translation>
    </message>
    <message>
        <source>It is black wherever it was sampled; all weights are zero.</source>
        <translation>Sie ist überall schwarz, wo sie abgetastet wurde; alle Gewichte sind null.</translation>
    </message>
    <message>
        <source>There are fewer than {0} samples: the diffuse part alone is fitted.</source>
        <translation>Es gibt weniger als {0} Messpunkte: Nur der diffuse Anteil wird angepasst.</translation>
    </message>
    <message>
        <source>No sample lies near the mirror direction: the diffuse part alone is fitted.</source>
        <translation>Kein Messpunkt liegt nahe der Spiegelrichtung: Nur der diffuse Anteil wird angepasst.</translation>
    </message>
    <message>
        <source>No sample lies near enough to the mirror direction for lobes sharper than exponent {0}: what gloss there is beyond is not in the fit.</source>
        <translation>Kein Messpunkt liegt nahe genug an der Spiegelrichtung für Keulen schärfer als Exponent {0}: Glanz darüber hinaus ist nicht in der Anpassung.</translation>
    </message>
    <message>
        <source>The light stood at {0}° only. Gloss and directional-diffuse parts cannot be separated with fewer than {1} incidences: all lobes are taken as directional-diffuse, and the split is undetermined.</source>
        <translation>Das Licht stand nur bei {0}°. Glanz und gerichtet-diffuser Anteil lassen sich mit weniger als {1} Einfallswinkeln nicht trennen: Alle Keulen gelten als gerichtet-diffus, und die Aufteilung ist unbestimmt.</translation>
    </message>
    <message>
        <source>Cosine lobes about the mirror direction miss {0} % of it, most of all with the light at {1}° and the view {2}° from its mirror direction.</source>
        <translation>Kosinuskeulen um die Spiegelrichtung verfehlen {0} % davon, am meisten mit dem Licht bei {1}° und dem Blick {2}° von seiner Spiegelrichtung.</translation>
    </message>
    <message>
        <source>{0} samples at the horizon are left out.</source>
        <translation>{0} Messpunkte am Horizont sind ausgelassen.</translation>
    </message>
    <message>
        <source>The samples differ with the surface&apos;s azimuth; the lobes, which do not, show their mean.</source>
        <translation>Die Messpunkte unterscheiden sich mit dem Azimut der Oberfläche; die Keulen, die es nicht tun, zeigen ihr Mittel.</translation>
    </message>
    <message>
        <source>It differs with the surface&apos;s azimuth; the lobes, which do not, show the mean over it.</source>
        <translation>Sie ändert sich mit dem Azimut der Oberfläche; die Keulen, die es nicht tun, zeigen das Mittel darüber.</translation>
    </message>
    <message>
        <source>{0} directions of the fit were not measured and are left out.</source>
        <translation>{0} Richtungen der Anpassung wurden nicht gemessen und sind ausgelassen.</translation>
    </message>
    <message>
        <source>of shape {0} does not match {1} sample weights</source>
        <translation>der Form {0} passt nicht zu {1} Gewichten der Messpunkte</translation>
    </message>
    <message>
        <source>The fitting system {0}.</source>
        <translation>Das Gleichungssystem der Anpassung {0}.</translation>
    </message>
    <message>
        <source>The fitting system holds a negative or not finite entry.</source>
        <translation>Das Gleichungssystem der Anpassung enthält einen negativen oder nicht endlichen Eintrag.</translation>
    </message>
    <message>
        <source>A sample weight is not a positive finite number.</source>
        <translation>Das Gewicht eines Messpunkts ist keine positive endliche Zahl.</translation>
    </message>
    <message>
        <source>There is no sample weighting {0}; choose one of {1}.</source>
        <translation>Es gibt keine Gewichtung {0} der Messpunkte; wählen Sie eine von {1}.</translation>
    </message>
    <message>
        <source>choose &apos;joint&apos; or &apos;measured&apos;</source>
        <translation>wählen Sie „joint“ oder „measured“</translation>
    </message>
    <message>
        <source>There is no way {0} for the diffuse term; {1}.</source>
        <translation>Es gibt keine Weise {0} für den diffusen Anteil; {1}.</translation>
    </message>
    <message>
        <source>The weights over the angles cannot be solved for.</source>
        <translation>Die Gewichte über den Winkeln lassen sich nicht berechnen.</translation>
    </message>
    <message>
        <source>The lobe weights {0} have shape {1}, not {2}.</source>
        <translation>Die Keulengewichte {0} haben die Form {1}, nicht {2}.</translation>
    </message>
    <message>
        <source>The lobe weights {0} hold a negative or not finite value.</source>
        <translation>Die Keulengewichte {0} enthalten einen negativen oder nicht endlichen Wert.</translation>
    </message>
    <message>
        <source>Fresnel&apos;s angle is &quot;light&quot; or &quot;view&quot;, not &quot;{0}&quot;.</source>
        <translation>Der Fresnel-Winkel ist „light“ oder „view“, nicht „{0}“.</translation>
    </message>
    <message>
        <source>direction to the light</source>
        <translation>Richtung zum Licht</translation>
    </message>
    <message>
        <source>direction to the viewer</source>
        <translation>Richtung zum Betrachter</translation>
    </message>
    <message>
        <source>half vector</source>
        <translation>Halbvektor</translation>
    </message>
    <message>
        <source>cosine between light and view</source>
        <translation>Kosinus zwischen Licht und Blick</translation>
    </message>
    <message>
        <source>cosine between light and half vector</source>
        <translation>Kosinus zwischen Licht und Halbvektor</translation>
    </message>
    <message>
        <source>radius of the light on a parabolic map</source>
        <translation>Radius des Lichts auf einer parabolischen Karte</translation>
    </message>
    <message>
        <source>radius of the view on a parabolic map</source>
        <translation>Radius des Blicks auf einer parabolischen Karte</translation>
    </message>
    <message>
        <source>radius of the half vector there</source>
        <translation>Radius des Halbvektors darauf</translation>
    </message>
    <message>
        <source>root of that radius, fine at a peak</source>
        <translation>Wurzel dieses Radius, fein an einer Spitze</translation>
    </message>
    <message>
        <source>cosines light to half vector, half vector to normal</source>
        <translation>Kosinus Licht zu Halbvektor, Halbvektor zu Normale</translation>
    </message>
    <message>
        <source>cosines of light and view, the smaller first</source>
        <translation>Kosinus von Licht und Blick, der kleinere zuerst</translation>
    </message>
    <message>
        <source>p:wo q:h p:wi</source>
        <translation>p:wo q:h p:wi</translation>
    </message>
    <message>
        <source>{0} is not map:projection with a projection of {1}, as in {2}</source>
        <translation>{0} ist nicht Karte:Projektion mit einer Projektion von {1}, wie in {2}</translation>
    </message>
    <message>
        <source>the map {0} cannot be over {1} and over something of another form</source>
        <translation>die Karte {0} kann nicht zugleich über {1} und über etwas anderer Form stehen</translation>
    </message>
    <message>
        <source>the map {0} cannot have {1} and {2} texels</source>
        <translation>die Karte {0} kann nicht {1} und {2} Texel haben</translation>
    </message>
    <message>
        <source>expected 1 to {0} factors, not {1}</source>
        <translation>erwartet wurden 1 bis {0} Faktoren, nicht {1}</translation>
    </message>
    <message>
        <source>nothing divides measured data into coat and base, so they cannot be fitted at several angles; leave out the number of angles.</source>
        <translation>nichts teilt gemessene Daten in Klarlack und Basis, sie lassen sich daher nicht bei mehreren Winkeln anpassen; lassen Sie die Anzahl der Winkel weg.</translation>
    </message>
    <message>
        <source>it has no coat and base to be fitted at several angles; leave out the number of angles.</source>
        <translation>es hat keinen Klarlack und keine Basis, die sich bei mehreren Winkeln anpassen ließen; lassen Sie die Anzahl der Winkel weg.</translation>
    </message>
    <message>
        <source>light at {0}°, view at {1}°, {2}° out of the plane</source>
        <translation>Licht bei {0}°, Blick bei {1}°, {2}° außerhalb der Ebene</translation>
    </message>
    <message>
        <source>albedo</source>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>reciprocity</source>
        <translation>Reziprozität</translation>
    </message>
    <message>
        <source>hemispherical albedo, {0}</source>
        <translation>hemisphärische Albedo, {0}</translation>
    </message>
    <message>
        <source>reciprocity error, worst</source>
        <translation>Reziprozitätsfehler, größter</translation>
    </message>
    <message>
        <source>reciprocity error, median</source>
        <translation>Reziprozitätsfehler, Median</translation>
    </message>
    <message>
        <source>albedo at {0}°</source>
        <translation>Albedo bei {0}°</translation>
    </message>
    <message>
        <source>albedo at {0}°, {1}</source>
        <translation>Albedo bei {0}°, {1}</translation>
    </message>
    <message>
        <source>ΔE00 of the fit {0}</source>
        <translation>ΔE00 der Anpassung {0}</translation>
    </message>
    <message>
        <source>ΔE00 to the reference {0}</source>
        <translation>ΔE00 zur Referenz {0}</translation>
    </message>
    <message>
        <source>, away from the mirror</source>
        <translation>, abseits der Spiegelrichtung</translation>
    </message>
    <message>
        <source>a surface is written as {0}, not {1}</source>
        <translation>eine Oberfläche wird als {0} geschrieben, nicht {1}</translation>
    </message>
    <message>
        <source>has no value in any direction, so that there is nothing to write</source>
        <translation>hat in keiner Richtung einen Wert, es gibt also nichts zu schreiben</translation>
    </message>
    <message>
        <source>BRDF Suite, a lobe surface</source>
        <translation>BRDF Suite, eine Keulenfläche</translation>
    </message>
    <message>
        <source>x along the tangent, z along the normal of the surface</source>
        <translation>x entlang der Tangente, z entlang der Normalen der Oberfläche</translation>
    </message>
    <message>
        <source>a value in 1/sr above 0 is wanted, not {0}</source>
        <translation>verlangt ist ein Wert über 0 in 1/sr, nicht {0}</translation>
    </message>
    <message>
        <source>{0} to {1} decades are shown</source>
        <translation>{0} bis {1} Dekaden werden gezeigt</translation>
    </message>
    <message>
        <source>{0}: the target is the source itself; name another file.</source>
        <translation>{0}: Das Ziel ist die Quelle selbst; nennen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>{0}, within {1}° of the normal</source>
        <translation>{0}, innerhalb von {1}° von der Normalen</translation>
    </message>
    <message>
        <source>{0}, none within {1}° of the steepest</source>
        <translation>{0}, keiner innerhalb von {1}° vom steilsten</translation>
    </message>
    <message>
        <source>{0} samples cannot be divided into a part to fit and a part to compare</source>
        <translation>{0} Messpunkte lassen sich nicht in einen Teil zum Anpassen und einen zum Vergleichen teilen</translation>
    </message>
    <message>
        <source>{0}; {1} or more are needed.</source>
        <translation>{0}; {1} oder mehr werden gebraucht.</translation>
    </message>
    <message>
        <source>a fifth of the samples, drawn at random</source>
        <translation>ein Fünftel der Messpunkte, zufällig gezogen</translation>
    </message>
    <message>
        <source>pairs even over √θh, θd and φd that no fit draws</source>
        <translation>Paare gleichmäßig über √θh, θd und φd, die keine Anpassung verwendet</translation>
    </message>
    <message>
        <source>The table has too few measured rows of θd to hold every fifth of them out.</source>
        <translation>Die Tabelle hat zu wenige gemessene Zeilen von θd, um jede fünfte zurückzuhalten.</translation>
    </message>
    <message>
        <source>bins of every fifth row of θd</source>
        <translation>Felder jeder fünften Zeile von θd</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>taking pictures of the flakes</source>
        <translation>Bilder der Flakes werden aufgenommen</translation>
    </message>
    <message>
        <source>sparkle grade {0}°</source>
        <translation>Glitzergrad {0}°</translation>
    </message>
    <message>
        <source>{0}: nearest {1} %, {2} %</source>
        <translation>{0}: nächster {1} %, {2} %</translation>
    </message>
    <message>
        <source>Not reachable with flakes in a paint of this colour: {0}.</source>
        <translation>Mit Flakes in einem Lack dieser Farbe nicht erreichbar: {0}.</translation>
    </message>
    <message>
        <source>expected up to {0} readings, at least one</source>
        <translation>erwartet wurden bis zu {0} Messwerte, mindestens einer</translation>
    </message>
    <message>
        <source>looking for flakes</source>
        <translation>Flakes werden gesucht</translation>
    </message>
    <message>
        <source>must have shape (h, w, 3), at least (4, 8, 3), not {0}</source>
        <translation>muss die Form (h, w, 3) haben, mindestens (4, 8, 3), nicht {0}</translation>
    </message>
    <message>
        <source>must be finite and never negative</source>
        <translation>muss endlich und darf nie negativ sein</translation>
    </message>
    <message>
        <source>analysing the environment</source>
        <translation>Umgebung wird ausgewertet</translation>
    </message>
    <message>
        <source>the compiled filter</source>
        <translation>das kompilierte Filter</translation>
    </message>
    <message>
        <source>compiling the filter, once for this machine</source>
        <translation>Filter wird kompiliert, einmal für diesen Rechner</translation>
    </message>
    <message>
        <source>filling the cube</source>
        <translation>Würfel wird gefüllt</translation>
    </message>
    <message>
        <source>must be a finite number above 0, not {0}</source>
        <translation>muss eine endliche Zahl über 0 sein, nicht {0}</translation>
    </message>
    <message>
        <source>reading the environment&apos;s rings</source>
        <translation>Ringe der Umgebung werden gelesen</translation>
    </message>
    <message>
        <source>lobe {0} is filtered</source>
        <translation>Keule {0} ist gefiltert</translation>
    </message>
    <message>
        <source>the environment is filtered</source>
        <translation>die Umgebung ist gefiltert</translation>
    </message>
    <message>
        <source>{0} lobe of exponent {1}</source>
        <translation>{0} Keule mit Exponent {1}</translation>
    </message>
    <message>
        <source>the table is made</source>
        <translation>die Tabelle ist fertig</translation>
    </message>
    <message>
        <source>latitude-longitude map, twice as wide as high</source>
        <translation>Längen-Breiten-Karte, doppelt so breit wie hoch</translation>
    </message>
    <message>
        <source>cube unfolded to 4 × 3 faces: left, front, right, back; up and down at the front</source>
        <translation>auf 4 × 3 Seiten entfalteter Würfel: links, vorn, rechts, hinten; oben und unten an der Vorderseite</translation>
    </message>
    <message>
        <source>cube unfolded to 3 × 4 faces: left, front, right; up above, down and back (turned) below</source>
        <translation>auf 3 × 4 Seiten entfalteter Würfel: links, vorn, rechts; oben darüber, unten und hinten (gedreht) darunter</translation>
    </message>
    <message>
        <source>six faces side by side: right, left, up, down, front, back</source>
        <translation>sechs Seiten nebeneinander: rechts, links, oben, unten, vorn, hinten</translation>
    </message>
    <message>
        <source>six faces one below the other, in the same order</source>
        <translation>sechs Seiten untereinander, in derselben Reihenfolge</translation>
    </message>
    <message>
        <source>six faces one below the other as OpenEXR&apos;s cube maps have them</source>
        <translation>sechs Seiten untereinander, wie die Würfelkarten von OpenEXR sie haben</translation>
    </message>
    <message>
        <source>fisheye of the upper half: the zenith in the middle, the horizon at the rim, the front below</source>
        <translation>Fischauge der oberen Hälfte: der Zenit in der Mitte, der Horizont am Rand, vorn unten</translation>
    </message>
    <message>
        <source>its shape is that of a {0} of cube faces</source>
        <translation>die Form ist die eines {0} aus Würfelseiten</translation>
    </message>
    <message>
        <source>a square image is taken as a light probe (angular); a mirror ball or a dome must be named</source>
        <translation>ein quadratisches Bild gilt als Lichtsonde (angular); eine Spiegelkugel oder eine Kuppel muss genannt werden</translation>
    </message>
    <message>
        <source>2:1 (latitude-longitude), 4:3 or 3:4 (cross), 6:1 or 1:6 (strip), 1:1 (light probe)</source>
        <translation>2:1 (Längen-Breiten), 4:3 oder 3:4 (Kreuz), 6:1 oder 1:6 (Streifen), 1:1 (Lichtsonde)</translation>
    </message>
    <message>
        <source>cannot be determined: {0} × {1} pixels; the shapes that are read are {2}</source>
        <translation>lässt sich nicht bestimmen: {0} × {1} Pixel; gelesen werden die Formen {2}</translation>
    </message>
    <message>
        <source>twice as wide as high</source>
        <translation>doppelt so breit wie hoch</translation>
    </message>
    <message>
        <source>{0} × {1} square faces</source>
        <translation>{0} × {1} quadratische Seiten</translation>
    </message>
    <message>
        <source>is {0}, which must be {1}, but the image is {2}</source>
        <translation>ist {0}, was {1} sein muss, das Bild ist aber {2}</translation>
    </message>
    <message>
        <source>laying the environment out</source>
        <translation>Umgebung wird ausgelegt</translation>
    </message>
    <message>
        <source>must have length 1</source>
        <translation>muss die Länge 1 haben</translation>
    </message>
    <message>
        <source>must have the shape {0}, not {1}</source>
        <translation>muss die Form {0} haben, nicht {1}</translation>
    </message>
    <message>
        <source>must be finite, and never negative</source>
        <translation>muss endlich und darf nie negativ sein</translation>
    </message>
    <message>
        <source>must be 1 to {0} lights, not {1}</source>
        <translation>es müssen 1 bis {0} Lichter sein, nicht {1}</translation>
    </message>
    <message>
        <source>must be one of {0}, not {1}</source>
        <translation>muss eines von {0} sein, nicht {1}</translation>
    </message>
    <message>
        <source>map file</source>
        <translation>Kartendatei</translation>
    </message>
    <message>
        <source>file of packed maps</source>
        <translation>Datei gepackter Karten</translation>
    </message>
    <message>
        <source>was made from another environment, or for other lobes</source>
        <translation>wurde aus einer anderen Umgebung oder für andere Keulen gemacht</translation>
    </message>
    <message>
        <source>header, key</source>
        <translation>Kopf, Schlüssel</translation>
    </message>
    <message>
        <source>is damaged ({0})</source>
        <translation>ist beschädigt ({0})</translation>
    </message>
    <message>
        <source>An overcast day: CIE standard overcast sky, 15 klx on flat ground without a skyline.</source>
        <translation>Ein bedeckter Tag: CIE-Normhimmel, bedeckt, 15 klx auf ebenem Boden ohne Silhouette.</translation>
    </message>
    <message>
        <source>{0} The value 1.0 is {1} cd/m².</source>
        <translation>{0} Der Wert 1,0 ist {1} cd/m².</translation>
    </message>
    <message>
        <source>drawing the light</source>
        <translation>Licht wird gezeichnet</translation>
    </message>
    <message>
        <source>Hošek and Wilkie 2012 and 2013</source>
        <translation>Hošek und Wilkie 2012 und 2013</translation>
    </message>
    <message>
        <source>Preetham, Shirley and Smits 1999; sun of Hošek and Wilkie 2013</source>
        <translation>Preetham, Shirley und Smits 1999; Sonne von Hošek und Wilkie 2013</translation>
    </message>
    <message>
        <source>CIE S 011, type 16 (Moon and Spencer 1942)</source>
        <translation>CIE S 011, Typ 16 (Moon und Spencer 1942)</translation>
    </message>
    <message>
        <source>, turbidity {0}, sun {1}° high</source>
        <translation>, Trübung {0}, Sonne {1}° hoch</translation>
    </message>
    <message>
        <source>A sky: {0}{1}, ground albedo {2}.</source>
        <translation>Ein Himmel: {0}{1}, Albedo des Bodens {2}.</translation>
    </message>
    <message>
        <source>A studio: {0}; {1} lamps.</source>
        <translation>Ein Studio: {0}; {1} Lampen.</translation>
    </message>
    <message>
        <source>A light booth: a grey room, 9 × 14 × 4.2 m, with soft boxes of 4 to 6 kcd/m², all neutral (D65).</source>
        <translation>Eine Lichtkabine: ein grauer Raum, 9 × 14 × 4,2 m, mit Softboxen von 4 bis 6 kcd/m², alles neutral (D65).</translation>
    </message>
    <message>
        <source>reading the picture</source>
        <translation>Bild wird gelesen</translation>
    </message>
    <message>
        <source>1 to {0} samples a pixel are taken, not {1}</source>
        <translation>1 bis {0} Abtastwerte je Pixel werden genommen, nicht {1}</translation>
    </message>
    <message>
        <source>1 to {0} exposures are averaged, not {1}</source>
        <translation>1 bis {0} Belichtungen werden gemittelt, nicht {1}</translation>
    </message>
    <message>
        <source>pictures are written as PNG or EXR; give a name that ends in {0}</source>
        <translation>Bilder werden als PNG oder EXR geschrieben; geben Sie einen Namen an, der auf {0} endet</translation>
    </message>
    <message>
        <source>{0} has {1} bits a channel, not {2}</source>
        <translation>{0} hat {1} Bit je Kanal, nicht {2}</translation>
    </message>
    <message>
        <source>PNG pictures are written in srgb or display-p3; rec2020 is for EXR</source>
        <translation>PNG-Bilder werden in srgb oder display-p3 geschrieben; rec2020 ist für EXR</translation>
    </message>
    <message>
        <source>its folder cannot be used: {0}</source>
        <translation>sein Ordner ist nicht verwendbar: {0}</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>sein Ordner existiert nicht</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>wird gezeichnet</translation>
    </message>
    <message>
        <source>drawing, {0} of {1} rows</source>
        <translation>wird gezeichnet, {0} von {1} Zeilen</translation>
    </message>
    <message>
        <source>{0} on {1} in {2}, {3} EV, light turned {4}°, tone curve {5}, fresnel {6}</source>
        <translation>{0} auf {1} in {2}, {3} EV, Licht um {4}° gedreht, Tonwertkurve {5}, Fresnel {6}</translation>
    </message>
    <message>
        <source>preparing the light ({0})</source>
        <translation>Licht wird vorbereitet ({0})</translation>
    </message>
    <message>
        <source>2 to {0} frames make a turn, not {1}</source>
        <translation>eine Drehung hat 2 bis {0} Bilder, nicht {1}</translation>
    </message>
    <message>
        <source>1 to 240 are played a second, not {0}</source>
        <translation>1 bis 240 werden je Sekunde gezeigt, nicht {0}</translation>
    </message>
    <message>
        <source>a shutter is open for 0 to 360°, not {0}</source>
        <translation>ein Verschluss ist über 0 bis 360° offen, nicht {0}</translation>
    </message>
    <message>
        <source>a video has 8 bits in sRGB and no transparency; a folder of PNG has them</source>
        <translation>ein Video hat 8 Bit in sRGB und keine Durchsichtigkeit; ein Ordner mit PNG hat sie</translation>
    </message>
    <message>
        <source>frame {0} of {1}</source>
        <translation>Bild {0} von {1}</translation>
    </message>
    <message>
        <source>a turntable is an .mp4, a .webm, or a folder of PNG pictures: a name without ending</source>
        <translation>eine Drehung ist ein .mp4, ein .webm oder ein Ordner mit PNG-Bildern: ein Name ohne Endung</translation>
    </message>
    <message>
        <source>is there already and not an empty folder; name a new one</source>
        <translation>gibt es schon und ist kein leerer Ordner; nennen Sie einen neuen</translation>
    </message>
    <message>
        <source>cannot be made: {0}</source>
        <translation>lässt sich nicht anlegen: {0}</translation>
    </message>
    <message>
        <source>exists already; choose another name, or --overwrite</source>
        <translation>gibt es schon; wählen Sie einen anderen Namen oder --overwrite</translation>
    </message>
    <message>
        <source>its folder cannot be written</source>
        <translation>in den Ordner lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>a turntable as a folder of PNG pictures needs nothing more</source>
        <translation>eine Drehung als Ordner mit PNG-Bildern braucht nichts weiter</translation>
    </message>
    <message>
        <source>a video</source>
        <translation>ein Video</translation>
    </message>
    <message>
        <source>a video needs ffmpeg, which the installed imageio-ffmpeg does not contain and the system does not offer; install the package ffmpeg with the package manager of this system, and {0}</source>
        <translation>ein Video braucht ffmpeg, das das installierte imageio-ffmpeg nicht enthält und das System nicht bietet; installieren Sie das Paket ffmpeg mit der Paketverwaltung dieses Systems, und {0}</translation>
    </message>
    <message>
        <source>a video has an even width and height: {0}x{1}, not {2}x{3}</source>
        <translation>ein Video hat eine gerade Breite und Höhe: {0}x{1}, nicht {2}x{3}</translation>
    </message>
    <message>
        <source>({0}, {1}, 3) uint8</source>
        <translation>({0}, {1}, 3) uint8</translation>
    </message>
    <message>
        <source>the video could not be made: {0}</source>
        <translation>das Video ließ sich nicht erzeugen: {0}</translation>
    </message>
    <message>
        <source>the video could not be made: ffmpeg gave no reason</source>
        <translation>das Video ließ sich nicht erzeugen: ffmpeg gab keinen Grund an</translation>
    </message>
    <message>
        <source>ffmpeg gave no reason</source>
        <translation>ffmpeg gab keinen Grund an</translation>
    </message>
    <message>
        <source>at least {0} readings under one light are wanted</source>
        <translation>verlangt sind mindestens {0} Messwerte unter einem Licht</translation>
    </message>
    <message>
        <source>there is a reading at {0}° already</source>
        <translation>es gibt schon einen Messwert bei {0}°</translation>
    </message>
    <message>
        <source>a paint needs at least {0} readings under one light, so this one stays</source>
        <translation>ein Lack braucht mindestens {0} Messwerte unter einem Licht, daher bleibt dieser</translation>
    </message>
    <message>
        <source>looking for the nearest paint</source>
        <translation>nächster Lack wird gesucht</translation>
    </message>
    <message>
        <source>reading {0}</source>
        <translation>{0} wird abgelesen</translation>
    </message>
    <message>
        <source>reading the colours</source>
        <translation>Farben werden abgelesen</translation>
    </message>
    <message>
        <source>reading the gloss</source>
        <translation>Glanz wird abgelesen</translation>
    </message>
    <message>
        <source>Read by the virtual spectrophotometer from {0}</source>
        <translation>Vom virtuellen Spektralfotometer abgelesen von {0}</translation>
    </message>
    <message>
        <source>Of flakes a reflectance says nothing: the design has none that can be seen singly.</source>
        <translation>Über Flakes sagt eine Reflexion nichts: Der Entwurf hat keine einzeln sichtbaren.</translation>
    </message>
    <message>
        <source>comparing at angles that were not used</source>
        <translation>wird an nicht verwendeten Winkeln verglichen</translation>
    </message>
    <message>
        <source>scattered samples lie too far apart for a mirror lobe</source>
        <translation>verstreute Messpunkte liegen zu weit auseinander für eine Spiegelkeule</translation>
    </message>
    <message>
        <source>the data are not finite numbers around the mirror direction</source>
        <translation>die Daten sind um die Spiegelrichtung keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>No gloss could be had of the data ({0}); {1} GU at 20° is set instead,</source>
        <translation>Aus den Daten ergab sich kein Glanz ({0}); stattdessen sind {1} GU bei 20° gesetzt,</translation>
    </message>
    <message>
        <source>{0} not measured.</source>
        <translation>{0} nicht gemessen.</translation>
    </message>
    <message>
        <source>{0} GU at {1}°</source>
        <translation>{0} GU bei {1}°</translation>
    </message>
    <message>
        <source>The glossmeter reads {0}, which no clearcoat gives; only the 20° reading is taken.</source>
        <translation>Das Glanzmessgerät zeigt {0}, was kein Klarlack ergibt; nur der 20°-Messwert wird genommen.</translation>
    </message>
    <message>
        <source>{0} {1} GU at 20°, the nearest found, is set instead.</source>
        <translation>{0} Stattdessen ist {1} GU bei 20° gesetzt, der nächste gefundene Wert.</translation>
    </message>
    <message>
        <source>The glossmeter reads {0}, and no clearcoat over these colours was found: {1}.</source>
        <translation>Das Glanzmessgerät zeigt {0}, und über diesen Farben wurde kein Klarlack gefunden: {1}.</translation>
    </message>
    <message>
        <source>At {0} L*a*b* {1} is beyond what a paint holds; the nearest is taken.</source>
        <translation>Bei {0} liegt L*a*b* {1} jenseits dessen, was ein Lack fasst; der nächste Wert gilt.</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>zurückgehalten</translation>
    </message>
    <message>
        <source>angles that were not used</source>
        <translation>nicht verwendete Winkel</translation>
    </message>
    <message>
        <source>The design cannot be drawn yet: {0}</source>
        <translation>Der Entwurf lässt sich noch nicht zeichnen: {0}</translation>
    </message>
    <message>
        <source>Between the angles the {0} rule is used: it is nearer to the original (ΔE00 {1} in the mean) than the {2} rule ({3}).</source>
        <translation>Zwischen den Winkeln gilt die {0}: Sie liegt näher am Original (ΔE00 {1} im Mittel) als die {2} ({3}).</translation>
    </message>
    <message>
        <source>from {0} to {1} is wanted, not {2}</source>
        <translation>verlangt ist {0} bis {1}, nicht {2}</translation>
    </message>
    <message>
        <source>both paints must be read at the same angles</source>
        <translation>beide Lacke müssen bei denselben Winkeln gemessen sein</translation>
    </message>
    <message>
        <source>{0} has no reading at {1}, and nothing that one could be computed from.</source>
        <translation>{0} hat keinen Messwert bei {1}, und nichts, woraus er sich berechnen ließe.</translation>
    </message>
    <message>
        <source>Its colours are read by the virtual spectrophotometer.</source>
        <translation>Seine Farben werden vom virtuellen Spektralfotometer abgelesen.</translation>
    </message>
    <message>
        <source>read</source>
        <translation>abgelesen</translation>
    </message>
    <message>
        <source>holds no paint, so there is no standard in it</source>
        <translation>enthält keinen Lack, also keinen Bezug</translation>
    </message>
    <message>
        <source>{0}: no sample can be a standard: {1}.</source>
        <translation>{0}: Keine Probe kann ein Bezug sein: {1}.</translation>
    </message>
    <message>
        <source>mean of {0} measurements, which differ from it by at most ΔE00 {1}</source>
        <translation>Mittel aus {0} Messungen, die davon um höchstens ΔE00 {1} abweichen</translation>
    </message>
    <message>
        <source>This paint has no flakes.</source>
        <translation>Dieser Lack hat keine Flakes.</translation>
    </message>
    <message>
        <source>{0} would be {1}, beyond {2} to {3}.</source>
        <translation>{0} wäre {1}, außerhalb von {2} bis {3}.</translation>
    </message>
    <message>
        <source>A grey has no chroma to change.</source>
        <translation>Ein Grau hat keine Buntheit, die sich ändern ließe.</translation>
    </message>
    <message>
        <source>Its largest chroma is {0}, less than the step.</source>
        <translation>Seine größte Buntheit ist {0}, weniger als der Schritt.</translation>
    </message>
    <message>
        <source>A grey has no hue to turn.</source>
        <translation>Ein Grau hat keinen Buntton, der sich drehen ließe.</translation>
    </message>
    <message>
        <source>A white has no depth.</source>
        <translation>Ein Weiß hat keine Tiefe.</translation>
    </message>
    <message>
        <source>It has the warmest hue already.</source>
        <translation>Er hat schon den wärmsten Buntton.</translation>
    </message>
    <message>
        <source>It has no flop left to take away.</source>
        <translation>Er hat keinen Flop mehr, der sich verringern ließe.</translation>
    </message>
    <message>
        <source>L* at {0} would be {1}, darker than black.</source>
        <translation>L* bei {0} wäre {1}, dunkler als Schwarz.</translation>
    </message>
    <message>
        <source>{0} at {1} would be {2}, beyond {3} to {4}.</source>
        <translation>{0} bei {1} wäre {2}, außerhalb von {3} bis {4}.</translation>
    </message>
    <message>
        <source>0 to {0} ΔE00 is wanted, not {1}</source>
        <translation>verlangt ist 0 bis {0} ΔE00, nicht {1}</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>verglichen</translation>
    </message>
    <message>
        <source>comparing {0} of {1}</source>
        <translation>{0} von {1} wird verglichen</translation>
    </message>
    <message>
        <source>measuring groups</source>
        <translation>Gruppen werden gemessen</translation>
    </message>
    <message>
        <source>measuring a group, {0} of {1}</source>
        <translation>eine Gruppe wird gemessen, {0} von {1}</translation>
    </message>
    <message>
        <source>the colour</source>
        <translation>die Farbe</translation>
    </message>
    <message>
        <source>the name</source>
        <translation>der Name</translation>
    </message>
    <message>
        <source>the group</source>
        <translation>die Gruppe</translation>
    </message>
    <message>
        <source>the code</source>
        <translation>der Code</translation>
    </message>
    <message>
        <source>the notes</source>
        <translation>die Notizen</translation>
    </message>
    <message>
        <source>the mark</source>
        <translation>das Zeichen</translation>
    </message>
    <message>
        <source>the usage</source>
        <translation>die Verwendung</translation>
    </message>
    <message>
        <source>the date</source>
        <translation>das Datum</translation>
    </message>
    <message>
        <source>the number of columns</source>
        <translation>die Anzahl der Spalten</translation>
    </message>
    <message>
        <source>what another program keeps in it</source>
        <translation>was ein anderes Programm darin ablegt</translation>
    </message>
    <message>
        <source>the place</source>
        <translation>der Platz</translation>
    </message>
    <message>
        <source>the palette {0}</source>
        <translation>die Palette {0}</translation>
    </message>
    <message>
        <source>the group {0}</source>
        <translation>die Gruppe {0}</translation>
    </message>
    <message>
        <source>the entry {0}</source>
        <translation>der Eintrag {0}</translation>
    </message>
    <message>
        <source>{0} is {1}</source>
        <translation>{0} ist {1}</translation>
    </message>
    <message>
        <source>here and was changed in the file</source>
        <translation>hier und wurde in der Datei geändert</translation>
    </message>
    <message>
        <source>in the file and was changed here</source>
        <translation>in der Datei und wurde hier geändert</translation>
    </message>
    <message>
        <source>{0} was removed {1}; it is kept as it was changed</source>
        <translation>{0} wurde {1} entfernt; es bleibt in der geänderten Form</translation>
    </message>
    <message>
        <source>the name of {0} was changed here and in the file: here {1}, in the file {2}; it stays as it is here</source>
        <translation>der Name von {0} wurde hier und in der Datei geändert: hier {1}, in der Datei {2}; es bleibt bei dem von hier</translation>
    </message>
    <message>
        <source>{0} of {1} was changed here and in the file</source>
        <translation>{0} von {1} wurde hier und in der Datei geändert</translation>
    </message>
    <message>
        <source>{0}; it stays as it is here</source>
        <translation>{0}; es bleibt, wie es hier ist</translation>
    </message>
    <message>
        <source>a colour at each of {0} angles is wanted</source>
        <translation>verlangt ist eine Farbe an jedem von {0} Winkeln</translation>
    </message>
    <message>
        <source>the colour is known at none of the angles</source>
        <translation>die Farbe ist an keinem der Winkel bekannt</translation>
    </message>
    <message>
        <source>a whole number of pixels is wanted, not {0}</source>
        <translation>verlangt ist eine ganze Zahl von Pixeln, nicht {0}</translation>
    </message>
    <message>
        <source>{0} to {1} pixels are drawn, not {2}</source>
        <translation>{0} bis {1} Pixel werden gezeichnet, nicht {2}</translation>
    </message>
    <message>
        <source>1 to {0} angles are wanted</source>
        <translation>verlangt sind 1 bis {0} Winkel</translation>
    </message>
    <message>
        <source>with the light at 45°, angles lie above -45° and below 135°</source>
        <translation>mit dem Licht bei 45° liegen Winkel über -45° und unter 135°</translation>
    </message>
    <message>
        <source>a size and a list of angles are wanted</source>
        <translation>verlangt sind eine Größe und eine Liste von Winkeln</translation>
    </message>
    <message>
        <source>the request</source>
        <translation>die Anforderung</translation>
    </message>
    <message>
        <source>The program met a fault of its own: {0}: {1}</source>
        <translation>Das Programm stieß auf einen eigenen Fehler: {0}: {1}</translation>
    </message>
    <message>
        <source>The pictures in {0} are in use by another program; doing without.</source>
        <translation>Die Bilder in {0} sind bei einem anderen Programm in Gebrauch; es geht ohne sie.</translation>
    </message>
    <message>
        <source>The kept pictures {0} are damaged ({1}); they are made anew.</source>
        <translation>Die aufbewahrten Bilder {0} sind beschädigt ({1}); sie werden neu gemacht.</translation>
    </message>
    <message>
        <source>Pictures of paints are not kept: {0} cannot be used ({1}). Make room there, or set {2} to another folder.</source>
        <translation>Bilder von Lacken werden nicht aufbewahrt: {0} ist nicht verwendbar ({1}). Schaffen Sie dort Platz, oder setzen Sie {2} auf einen anderen Ordner.</translation>
    </message>
    <message>
        <source>it holds another table</source>
        <translation>es enthält eine andere Tabelle</translation>
    </message>
    <message>
        <source>must be {0} or one of {1}, not {2}</source>
        <translation>muss {0} oder eines von {1} sein, nicht {2}</translation>
    </message>
    <message>
        <source>Its product has more than {0} maps, too many to be drawn by: lamps light the lobes instead.</source>
        <translation>Sein Produkt hat mehr als {0} Karten, zu viele zum Zeichnen: Lampen beleuchten stattdessen die Keulen.</translation>
    </message>
    <message>
        <source>8 light directions by 16 x 32 views, even in solid angle over both hemispheres (midpoints in cos θ and φ)</source>
        <translation>8 Lichtrichtungen mal 16 x 32 Blickrichtungen, gleichmäßig im Raumwinkel über beide Halbkugeln (Mittelpunkte in cos θ und φ)</translation>
    </message>
    <message>
        <source>each fifth of the samples by a fit to the other four, weighted by the solid angle of views they stand for</source>
        <translation>jedes Fünftel der Messpunkte durch eine Anpassung an die anderen vier, gewichtet mit dem Raumwinkel der Blickrichtungen, für die sie stehen</translation>
    </message>
    <message>
        <source>It has no separate coat, so of the settings of the fit the exponents alone apply: the diffuse term is fitted with the lobes, and the weights of the samples are those of measured data.</source>
        <translation>Sie hat keinen getrennten Klarlack, daher gelten von den Einstellungen der Anpassung nur die Exponenten: Der diffuse Anteil wird mit den Keulen angepasst, und die Gewichte der Messpunkte sind die gemessener Daten.</translation>
    </message>
    <message>
        <source>The lobes are fitted with the light at {0}°; the readings under other lights enter the picture by weights fitted for every angle of the view. The error stated at such a reading is that of lobes fitted with its light.</source>
        <translation>Die Keulen sind mit dem Licht bei {0}° angepasst; die Messwerte unter anderen Lichtern gehen durch Gewichte in das Bild ein, die für jeden Blickwinkel angepasst sind. Der an einem solchen Messwert genannte Fehler ist der von Keulen, die mit seinem Licht angepasst sind.</translation>
    </message>
    <message>
        <source>It has no sharp lobe that would be a coat: everything is fitted as base.</source>
        <translation>Sie hat keine scharfe Keule, die ein Klarlack wäre: Alles wird als Basis angepasst.</translation>
    </message>
    <message>
        <source>A flat colour has no gloss and no angles; it is shown as a solid paint of that colour.</source>
        <translation>Eine einzelne Farbe hat keinen Glanz und keine Winkel; sie wird als Unilack dieser Farbe gezeigt.</translation>
    </message>
    <message>
        <source>Scattered samples are interpolated: gloss, and colours far from any sample, are only as good as the samples near them.</source>
        <translation>Verstreute Messpunkte werden interpoliert: Glanz, und Farben fern von jedem Messpunkt, sind nur so gut wie die Messpunkte in ihrer Nähe.</translation>
    </message>
    <message>
        <source>Its spectra are seen through the {0}° observer; L*a*b* follows from the working space, as for every reading.</source>
        <translation>Seine Spektren werden mit dem {0}°-Beobachter gesehen; L*a*b* folgt aus dem Arbeitsfarbraum, wie bei jedem Messwert.</translation>
    </message>
    <message>
        <source>holds no {0} file</source>
        <translation>enthält keine {0}-Datei</translation>
    </message>
    <message>
        <source>is a palette of {0} paints; name one of them, as in {1}</source>
        <translation>ist eine Palette mit {0} Lacken; nennen Sie einen davon, wie in {1}</translation>
    </message>
    <message>
        <source>has no entry {0}</source>
        <translation>hat keinen Eintrag {0}</translation>
    </message>
    <message>
        <source>is neither a paint nor a palette nor measured data of a format that is known here (the pages measured_files and formats of the documents list them)</source>
        <translation>ist weder ein Lack noch eine Palette noch Messdaten eines hier bekannten Formats (die Seiten measured_files und formats der Dokumentation führen sie auf)</translation>
    </message>
    <message>
        <source>angle fitter</source>
        <translation>Anpassung über die Winkel</translation>
    </message>
    <message>
        <source>weights by the view</source>
        <translation>Gewichte nach dem Blick</translation>
    </message>
    <message>
        <source>with the view at {0}° from the normal</source>
        <translation>mit dem Blick bei {0}° von der Normalen</translation>
    </message>
    <message>
        <source>reading the surface</source>
        <translation>Oberfläche wird gelesen</translation>
    </message>
    <message>
        <source>shaping the surface</source>
        <translation>Oberfläche wird geformt</translation>
    </message>
    <message>
        <source>{0} The picture is drawn without occlusion and ground.</source>
        <translation>{0} Das Bild wird ohne Umgebungsverdeckung und Boden gezeichnet.</translation>
    </message>
    <message>
        <source>computing ambient occlusion</source>
        <translation>Umgebungsverdeckung wird berechnet</translation>
    </message>
    <message>
        <source>reading the images</source>
        <translation>Bilder werden gelesen</translation>
    </message>
    <message>
        <source>fitting the second paint</source>
        <translation>zweiter Lack wird angepasst</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>plug-in {0} ({1}, {2})</source>
        <translation>Plug-in {0} ({1}, {2})</translation>
    </message>
    <message>
        <source>The {0} failed: {1}.</source>
        <translation>Das {0} ist fehlgeschlagen: {1}.</translation>
    </message>
    <message>
        <source>the name {0} is taken</source>
        <translation>der Name {0} ist vergeben</translation>
    </message>
    <message>
        <source>The {0} is skipped: {1}.</source>
        <translation>Das {0} wird übergangen: {1}.</translation>
    </message>
    <message>
        <source>unknown package</source>
        <translation>unbekanntes Paket</translation>
    </message>
    <message>
        <source>the table of look-ups cannot be read; install brdf-suite again</source>
        <translation>die Nachschlagetabelle ist nicht lesbar; installieren Sie brdf-suite neu</translation>
    </message>
    <message>
        <source>loading the broad lobes&apos; maps</source>
        <translation>Laden der Karten der breiten Keulen</translation>
    </message>
    <message>
        <source>loading the environment&apos;s maps</source>
        <translation>Laden der Karten der Umgebung</translation>
    </message>
    <message>
        <source>drawing a ball of {0}</source>
        <translation>Zeichnen einer Kugel von {0}</translation>
    </message>
    <message>
        <source>writing the factors of {0}</source>
        <translation>Schreiben der Faktoren von {0}</translation>
    </message>
    <message>
        <source>expected (n, 3) or (rows, columns, 3), not {0}</source>
        <translation>erwartet wurde (n, 3) oder (Zeilen, Spalten, 3), nicht {0}</translation>
    </message>
    <message>
        <source>at most {0} texels along an edge, not {1}</source>
        <translation>höchstens {0} Texel entlang einer Kante, nicht {1}</translation>
    </message>
    <message>
        <source>not every number is finite</source>
        <translation>nicht jede Zahl ist endlich</translation>
    </message>
    <message>
        <source>expected logarithms within ±{0}</source>
        <translation>erwartet wurden Logarithmen innerhalb von ±{0}</translation>
    </message>
    <message>
        <source>must not be negative</source>
        <translation>darf nicht negativ sein</translation>
    </message>
    <message>
        <source>expected finite numbers that are not negative</source>
        <translation>erwartet wurden endliche Zahlen, die nicht negativ sind</translation>
    </message>
    <message>
        <source>{0} is none of {1}</source>
        <translation>{0} ist keines von {1}</translation>
    </message>
    <message>
        <source>expected an index of 1 to 100 and shares of 0 to 1, not {0}</source>
        <translation>erwartet wurden eine Brechzahl von 1 bis 100 und Anteile von 0 bis 1, nicht {0}</translation>
    </message>
    <message>
        <source>1 to {0} maps are drawn, not {1}</source>
        <translation>1 bis {0} Karten werden gezeichnet, nicht {1}</translation>
    </message>
    <message>
        <source>1 or more with {0} factors in all, not {1}</source>
        <translation>1 oder mehr mit insgesamt {0} Faktoren, nicht {1}</translation>
    </message>
    <message>
        <source>expected a number above 0, to 10⁸, not {0}</source>
        <translation>erwartet wurde eine Zahl über 0, bis 10⁸, nicht {0}</translation>
    </message>
    <message>
        <source>there is no map {0}</source>
        <translation>es gibt keine Karte {0}</translation>
    </message>
    <message>
        <source>the map {0} is read in two forms</source>
        <translation>die Karte {0} wird in zwei Formen gelesen</translation>
    </message>
    <message>
        <source>the map {0} is not of the form of {1}</source>
        <translation>die Karte {0} hat nicht die Form von {1}</translation>
    </message>
    <message>
        <source>nothing reads {0}</source>
        <translation>nichts liest {0}</translation>
    </message>
    <message>
        <source>Install Mesa&apos;s EGL (on Debian: apt-get install libegl1 libgl1-mesa-dri) or a graphics driver</source>
        <translation>Installieren Sie EGL von Mesa (unter Debian: apt-get install libegl1 libgl1-mesa-dri) oder einen Grafiktreiber</translation>
    </message>
    <message>
        <source>Install the graphics driver of the machine</source>
        <translation>Installieren Sie den Grafiktreiber des Rechners</translation>
    </message>
    <message>
        <source>OpenGL 3.3 needs a graphical login session on macOS</source>
        <translation>OpenGL 3.3 braucht unter macOS eine grafische Sitzung</translation>
    </message>
    <message>
        <source>software rasterizer</source>
        <translation>Software-Rasterisierer</translation>
    </message>
    <message>
        <source>No OpenGL 3.3 context could be made ({0}). {1}.</source>
        <translation>Es ließ sich kein OpenGL-3.3-Kontext anlegen ({0}). {1}.</translation>
    </message>
    <message>
        <source>The window has no usable OpenGL context ({0}). {1}.</source>
        <translation>Das Fenster hat keinen brauchbaren OpenGL-Kontext ({0}). {1}.</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed, but {0} offers {1}. {2}.</source>
        <translation>OpenGL 3.3 wird gebraucht, {0} bietet aber {1}. {2}.</translation>
    </message>
    <message>
        <source>The graphics driver failed while {0}: {1}.</source>
        <translation>Der Grafiktreiber versagte ({0}): {1}.</translation>
    </message>
    <message>
        <source>reserving {0} bytes</source>
        <translation>Reservieren von {0} Byte</translation>
    </message>
    <message>
        <source>making a cube map of {0} texels</source>
        <translation>Anlegen einer Würfelkarte von {0} Texeln</translation>
    </message>
    <message>
        <source>making a stack of {0} maps of {1} texels</source>
        <translation>Anlegen eines Stapels von {0} Karten mit {1} Texeln</translation>
    </message>
    <message>
        <source>making a table of {0}x{1} numbers</source>
        <translation>Anlegen einer Tabelle von {0}x{1} Zahlen</translation>
    </message>
    <message>
        <source>making an image of {0}x{1} pixels</source>
        <translation>Anlegen eines Bildes von {0}x{1} Pixeln</translation>
    </message>
    <message>
        <source>making a depth buffer of {0}x{1} pixels</source>
        <translation>Anlegen eines Tiefenpuffers von {0}x{1} Pixeln</translation>
    </message>
    <message>
        <source>making a depth map of {0}x{1} pixels</source>
        <translation>Anlegen einer Tiefenkarte von {0}x{1} Pixeln</translation>
    </message>
    <message>
        <source>making a framebuffer</source>
        <translation>Anlegen eines Framebuffers</translation>
    </message>
    <message>
        <source>making a query</source>
        <translation>Anlegen einer Abfrage</translation>
    </message>
    <message>
        <source>making a vertex array</source>
        <translation>Anlegen einer Vertexliste</translation>
    </message>
    <message>
        <source>vertex array</source>
        <translation>Vertexliste</translation>
    </message>
    <message>
        <source>The shader file {0} is missing{1}; install brdf-suite again.</source>
        <translation>Die Shaderdatei {0} fehlt{1}; installieren Sie brdf-suite neu.</translation>
    </message>
    <message>
        <source>, asked for by {0}, line {1}</source>
        <translation>, verlangt von {0}, Zeile {1}</translation>
    </message>
    <message>
        <source>{0} with {1}</source>
        <translation>{0} mit {1}</translation>
    </message>
    <message>
        <source>The shader {0}, line {1}, does not compile: {2}.</source>
        <translation>Der Shader {0}, Zeile {1}, lässt sich nicht übersetzen: {2}.</translation>
    </message>
    <message>
        <source>The shaders {0} do not compile or link: {1}.</source>
        <translation>Die Shader {0} lassen sich nicht übersetzen oder binden: {1}.</translation>
    </message>
    <message>
        <source>expected finite numbers of the shape {0}, not {1}</source>
        <translation>erwartet wurden endliche Zahlen der Form {0}, nicht {1}</translation>
    </message>
    <message>
        <source>drawing the flakes</source>
        <translation>Zeichnen der Flakes</translation>
    </message>
    <message>
        <source>writing the light that flakes mirror</source>
        <translation>Schreiben des Lichts, das die Flakes spiegeln</translation>
    </message>
    <message>
        <source>drawing the shadow of a light</source>
        <translation>Zeichnen des Schattens einer Lampe</translation>
    </message>
    <message>
        <source>writing the lights</source>
        <translation>Schreiben der Lampen</translation>
    </message>
    <message>
        <source>writing the lobes of {0}</source>
        <translation>Schreiben der Keulen von {0}</translation>
    </message>
    <message>
        <source>The material {0} was fitted to {1}, but the environment was filtered for {2}; fit it again.</source>
        <translation>Das Material {0} wurde an {1} angepasst, die Umgebung aber für {2} gefiltert; passen Sie es neu an.</translation>
    </message>
    <message>
        <source>writing the weights of {0}</source>
        <translation>Schreiben der Gewichte von {0}</translation>
    </message>
    <message>
        <source>{0} lobes ({1})</source>
        <translation>{0} Keulen ({1})</translation>
    </message>
    <message>
        <source>expected {0} lobes, as in the single fit</source>
        <translation>erwartet wurden {0} Keulen, wie in der einzelnen Anpassung</translation>
    </message>
    <message>
        <source>A material has weights on {0} broad and {1} sharp lobes; at most {2} and {3} are drawn. Choose a basis of fewer lobes.</source>
        <translation>Ein Material hat Gewichte auf {0} breiten und {1} scharfen Keulen; gezeichnet werden höchstens {2} und {3}. Wählen Sie eine Basis mit weniger Keulen.</translation>
    </message>
    <message>
        <source>the driver gives no reason</source>
        <translation>der Treiber nennt keinen Grund</translation>
    </message>
    <message>
        <source>pictures of palettes have 8 bits</source>
        <translation>Bilder von Paletten haben 8 Bit</translation>
    </message>
    <message>
        <source>drawing pictures of paints</source>
        <translation>Zeichnen von Lackbildern</translation>
    </message>
    <message>
        <source>capturing a form</source>
        <translation>Erfassen einer Form</translation>
    </message>
    <message>
        <source>The picture has {0}x{1} pixels; this graphics card takes {2} along an edge.</source>
        <translation>Das Bild hat {0}x{1} Pixel; diese Grafikkarte nimmt {2} entlang einer Kante.</translation>
    </message>
    <message>
        <source>uploading the picture</source>
        <translation>Hochladen des Bildes</translation>
    </message>
    <message>
        <source>looking the light of a form up</source>
        <translation>Nachschlagen des Lichts einer Form</translation>
    </message>
    <message>
        <source>No environment has been chosen yet; choose one before drawing.</source>
        <translation>Noch ist keine Umgebung gewählt; wählen Sie eine, bevor gezeichnet wird.</translation>
    </message>
    <message>
        <source>1 to 65,536 pixels along each edge are drawn, not {0}x{1}</source>
        <translation>1 bis 65.536 Pixel entlang jeder Kante werden gezeichnet, nicht {0}x{1}</translation>
    </message>
    <message>
        <source>reading the geometry of a picture</source>
        <translation>Lesen der Geometrie eines Bildes</translation>
    </message>
    <message>
        <source>looking for the parts in the picture</source>
        <translation>Suchen der Teile im Bild</translation>
    </message>
    <message>
        <source>looking for the surface under the cursor</source>
        <translation>Suchen der Oberfläche unter dem Zeiger</translation>
    </message>
    <message>
        <source>drawing a frame</source>
        <translation>Zeichnen eines Bildes</translation>
    </message>
    <message>
        <source>finishing a picture</source>
        <translation>Fertigstellen eines Bildes</translation>
    </message>
    <message>
        <source>counting pixels</source>
        <translation>Zählen der Pixel</translation>
    </message>
    <message>
        <source>at most {0} pixels along an edge are captured</source>
        <translation>höchstens {0} Pixel entlang einer Kante werden erfasst</translation>
    </message>
    <message>
        <source>lamps and relief are not captured; draw such a view paint by paint</source>
        <translation>Lampen und Relief werden nicht erfasst; zeichnen Sie eine solche Ansicht Lack für Lack</translation>
    </message>
    <message>
        <source>two paints on one form are not captured</source>
        <translation>zwei Lacke auf einer Form werden nicht erfasst</translation>
    </message>
    <message>
        <source>glare is not captured; it depends on the whole picture</source>
        <translation>Blendung wird nicht erfasst; sie hängt vom ganzen Bild ab</translation>
    </message>
    <message>
        <source>reading a pixel</source>
        <translation>Lesen eines Pixels</translation>
    </message>
    <message>
        <source>drawing a picture</source>
        <translation>Zeichnen eines Bildes</translation>
    </message>
    <message>
        <source>shape {0}, not (h, w, 4) or (h, w, 7)</source>
        <translation>Form {0}, nicht (h, w, 4) oder (h, w, 7)</translation>
    </message>
    <message>
        <source>uploading the traced picture</source>
        <translation>Hochladen des verfolgten Bildes</translation>
    </message>
    <message>
        <source>uploading the shadow on the ground</source>
        <translation>Hochladen des Schattens auf dem Boden</translation>
    </message>
    <message>
        <source>drawing the traced picture</source>
        <translation>Zeichnen des verfolgten Bildes</translation>
    </message>
    <message>
        <source>expected 1 or more, not {0}</source>
        <translation>erwartet wurde 1 oder mehr, nicht {0}</translation>
    </message>
    <message>
        <source>expected shares of 0 to 1</source>
        <translation>erwartet wurden Anteile von 0 bis 1</translation>
    </message>
    <message>
        <source>expected rows, columns and {0} numbers, not {1}</source>
        <translation>erwartet wurden Zeilen, Spalten und {0} Zahlen, nicht {1}</translation>
    </message>
    <message>
        <source>part {0}: positions</source>
        <translation>Teil {0}: Positionen</translation>
    </message>
    <message>
        <source>part {0}: normals</source>
        <translation>Teil {0}: Normalen</translation>
    </message>
    <message>
        <source>part {0}: triangles</source>
        <translation>Teil {0}: Dreiecke</translation>
    </message>
    <message>
        <source>expected whole numbers (k, 3)</source>
        <translation>erwartet wurden ganze Zahlen (k, 3)</translation>
    </message>
    <message>
        <source>1 or more, with indices 0 to {0}</source>
        <translation>1 oder mehr, mit Indizes von 0 bis {0}</translation>
    </message>
    <message>
        <source>part {0}: uvs</source>
        <translation>Teil {0}: Texturkoordinaten</translation>
    </message>
    <message>
        <source>part {0}: light</source>
        <translation>Teil {0}: Licht</translation>
    </message>
    <message>
        <source>expected a finite height and edges, the highest above the lowest</source>
        <translation>erwartet wurden eine endliche Höhe und Kanten, die höchste über der niedrigsten</translation>
    </message>
    <message>
        <source>expected (rows, columns, squared number), not {0}</source>
        <translation>erwartet wurde (Zeilen, Spalten, Quadratzahl), nicht {0}</translation>
    </message>
    <message>
        <source>ground: transfer</source>
        <translation>Boden: Übertragung</translation>
    </message>
    <message>
        <source>expected six square faces (6, F, F, 3), not {0}</source>
        <translation>erwartet wurden sechs quadratische Seiten (6, F, F, 3), nicht {0}</translation>
    </message>
    <message>
        <source>expected a finite number above 0, not {0}</source>
        <translation>erwartet wurde eine endliche Zahl über 0, nicht {0}</translation>
    </message>
    <message>
        <source>expected {0} maps, not {1}</source>
        <translation>erwartet wurden {0} Karten, nicht {1}</translation>
    </message>
    <message>
        <source>weights must not be negative</source>
        <translation>Gewichte dürfen nicht negativ sein</translation>
    </message>
    <message>
        <source>expected 0 to below π/2, not {0}</source>
        <translation>erwartet wurde 0 bis unter π/2, nicht {0}</translation>
    </message>
    <message>
        <source>expected 1 to 100, not {0}</source>
        <translation>erwartet wurde 1 bis 100, nicht {0}</translation>
    </message>
    <message>
        <source>expected 0 to 1, not {0}</source>
        <translation>erwartet wurde 0 bis 1, nicht {0}</translation>
    </message>
    <message>
        <source>expected one row of numbers, not {0}</source>
        <translation>erwartet wurde eine Zeile von Zahlen, nicht {0}</translation>
    </message>
    <message>
        <source>1 to {0} lobes are drawn, not {1}</source>
        <translation>1 bis {0} Keulen werden gezeichnet, nicht {1}</translation>
    </message>
    <message>
        <source>each must be finite and at least 1</source>
        <translation>jeder muss endlich und mindestens 1 sein</translation>
    </message>
    <message>
        <source>expected shape {0}, not {1}</source>
        <translation>erwartet wurde Form {0}, nicht {1}</translation>
    </message>
    <message>
        <source>The reference renderer has no formula for this reflectance; it renders a table of it in half-angle coordinates (90 × 90 × 180 bins, mean over azimuths assumed).</source>
        <translation>Der Referenzrenderer hat keine Formel für diese Reflexion; er zeichnet eine Tabelle davon in Halbwinkelkoordinaten (90 × 90 × 180 Felder, Mittel über die Azimute angenommen).</translation>
    </message>
    <message>
        <source>path tracing</source>
        <translation>Pfadverfolgung</translation>
    </message>
    <message>
        <source>The reference renderer failed ({0}); try a smaller picture, or fewer samples in a pass.</source>
        <translation>Der Referenzrenderer versagte ({0}); versuchen Sie ein kleineres Bild, oder weniger Abtastwerte je Durchgang.</translation>
    </message>
    <message>
        <source>tracing</source>
        <translation>Verfolgung</translation>
    </message>
    <message>
        <source>{0} samples, {1} s left</source>
        <translation>{0} Abtastwerte, noch {1} s</translation>
    </message>
    <message>
        <source>The denoiser is OptiX&apos;s and needs an NVIDIA graphics card; here paths are traced without one. Leave --denoise out, and give more samples instead (--spp).</source>
        <translation>Der Entrauscher ist der von OptiX und braucht eine NVIDIA-Grafikkarte; hier werden Pfade ohne eine solche verfolgt. Lassen Sie --denoise weg, und nehmen Sie stattdessen mehr Abtastwerte (--spp).</translation>
    </message>
    <message>
        <source>The graphics card&apos;s driver has no denoiser that can be used ({0}); leave --denoise out.</source>
        <translation>Der Treiber der Grafikkarte hat keinen brauchbaren Entrauscher ({0}); lassen Sie --denoise weg.</translation>
    </message>
    <message>
        <source>The ray tracer failed ({0}); try a smaller picture, or a lower quality.</source>
        <translation>Der Strahlverfolger versagte ({0}); versuchen Sie ein kleineres Bild, oder eine niedrigere Qualität.</translation>
    </message>
    <message>
        <source>Rendered as a table by Mitsuba&apos;s own plug-in: within 0.1 % of the paint for light and view 17° and more above the surface, within percents below that.</source>
        <translation>Als Tabelle durch das eigene Modul von Mitsuba gezeichnet: auf 0,1 % des Lacks für Licht und Blick von 17° und mehr über der Oberfläche, darunter auf Prozente.</translation>
    </message>
    <message>
        <source>Without LLVM only isotropic reflectances can be path-traced: {0} Install libllvm19.</source>
        <translation>Ohne LLVM lassen sich nur isotrope Reflexionen pfadverfolgen: {0} Installieren Sie libllvm19.</translation>
    </message>
    <message>
        <source>holds no render to resume from ({0}); remove it, or render to another file</source>
        <translation>enthält kein Bild, das sich fortsetzen ließe ({0}); entfernen Sie es, oder zeichnen Sie in eine andere Datei</translation>
    </message>
    <message>
        <source>Mitsuba, without LLVM</source>
        <translation>Mitsuba, ohne LLVM</translation>
    </message>
    <message>
        <source>{0} is LLVM {1}</source>
        <translation>{0} ist LLVM {1}</translation>
    </message>
    <message>
        <source>The reference renderer needs the library LLVM, version {0} or later; install the package {1} (sudo apt-get install {2}), or set {3} to the library&apos;s file.{4}</source>
        <translation>Der Referenzrenderer braucht die Bibliothek LLVM, Version {0} oder neuer; installieren Sie das Paket {1} (sudo apt-get install {2}), oder setzen Sie {3} auf die Datei der Bibliothek.{4}</translation>
    </message>
    <message>
        <source>the trial could not be made ({0})</source>
        <translation>der Versuch ließ sich nicht ausführen ({0})</translation>
    </message>
    <message>
        <source>ended with signal {0}</source>
        <translation>endete mit Signal {0}</translation>
    </message>
    <message>
        <source>its trial {0} ({1})</source>
        <translation>sein Versuch {0} ({1})</translation>
    </message>
    <message>
        <source>its trial {0} (without a word)</source>
        <translation>sein Versuch {0} (ohne ein Wort)</translation>
    </message>
    <message>
        <source>without a word</source>
        <translation>ohne ein Wort</translation>
    </message>
    <message>
        <source>{0} at {1}°, {2}</source>
        <translation>{0} bei {1}°, {2}</translation>
    </message>
    <message>
        <source>of the light</source>
        <translation>des Lichts</translation>
    </message>
    <message>
        <source>known violator</source>
        <translation>bekannter Verstoß</translation>
    </message>
    <message>
        <source>declared, not seen</source>
        <translation>angegeben, nicht gesehen</translation>
    </message>
    <message>
        <source>light at ({0}°, {1}°), view at ({2}°, {3}°) polar, azimuth</source>
        <translation>Licht bei ({0}°, {1}°), Blick bei ({2}°, {3}°) Polarwinkel, Azimut</translation>
    </message>
    <message>
        <source>No clearcoat was found that gives {0} GU at 20° over the measured colours; change the gloss, or the colour nearest to the mirror direction.</source>
        <translation>Es wurde kein Klarlack gefunden, der über den gemessenen Farben {0} GU bei 20° ergibt; ändern Sie den Glanz, oder die Farbe, die der Spiegelrichtung am nächsten liegt.</translation>
    </message>
    <message>
        <source>This paint would reflect {0} times the light that falls on it.</source>
        <translation>Dieser Lack würde das {0}-Fache des einfallenden Lichts reflektieren.</translation>
    </message>
    <message>
        <source>{0}: at least 3 readings with the same light angle are needed, there are at most {1} (at {2}°).</source>
        <translation>{0}: Mindestens 3 Messwerte mit demselben Lichtwinkel werden gebraucht, es gibt höchstens {1} (bei {2}°).</translation>
    </message>
    <message>
        <source>The colour at {0}°{1} is more saturated than the working space holds; it is shown with ΔE00 {2}.</source>
        <translation>Die Farbe bei {0}°{1} ist gesättigter, als der Arbeitsfarbraum fasst; sie wird mit ΔE00 {2} gezeigt.</translation>
    </message>
    <message>
        <source>Light at {0}°: {1}</source>
        <translation>Licht bei {0}°: {1}</translation>
    </message>
    <message>
        <source>The tilt of the half vector belongs to the flake rule; here the aspecular angle is used.</source>
        <translation>Die Neigung des Halbvektors gehört zur Flake-Regel; hier gilt der Aspekularwinkel.</translation>
    </message>
    <message>
        <source>At {0}° the clearcoat of this gloss alone reflects {1} (reflectance factor), more than the {2} that the colour has in the {3} channel, so the base would be negative. Raise the gloss or the lightness.</source>
        <translation>Bei {0}° reflektiert allein der Klarlack dieses Glanzes {1} (Reflexionsfaktor), mehr als die {2}, die die Farbe im Kanal {3} hat; die Basis wäre negativ. Erhöhen Sie den Glanz oder die Helligkeit.</translation>
    </message>
    <message>
        <source>There are fewer than three different aspecular angles: straight lines in L*a*b* join them.</source>
        <translation>Es gibt weniger als drei verschiedene Aspekularwinkel: Geraden in L*a*b* verbinden sie.</translation>
    </message>
    <message>
        <source>The polynomial turns negative between {0}° and {1}°; the base is black there.</source>
        <translation>Das Polynom wird zwischen {0}° und {1}° negativ; die Basis ist dort schwarz.</translation>
    </message>
    <message>
        <source>No spread of flakes gives these colours: between the angles the monotone rule is used.</source>
        <translation>Keine Streuung von Flakes ergibt diese Farben: Zwischen den Winkeln gilt die monotone Regel.</translation>
    </message>
    <message>
        <source>The colours need flake tilts spread by {0}; real flake paints have about 0.15 to 0.19.</source>
        <translation>Die Farben brauchen um {0} gestreute Flake-Neigungen; echte Flake-Lacke haben etwa 0,15 bis 0,19.</translation>
    </message>
    <message>
        <source>{0} at {1}° with the light at {2}°</source>
        <translation>{0} bei {1}° mit dem Licht bei {2}°</translation>
    </message>
    <message>
        <source>The rule does not pass through every reading of this paint: ΔE00 {0}.</source>
        <translation>Die Regel geht nicht durch jeden Messwert dieses Lacks: ΔE00 {0}.</translation>
    </message>
    <message>
        <source>the table of facets cannot be read; install brdf-suite again</source>
        <translation>die Tabelle der Facetten ist nicht lesbar; installieren Sie brdf-suite neu</translation>
    </message>
    <message>
        <source>a map between whose logarithms is interpolated holds a 0</source>
        <translation>eine Karte, zwischen deren Logarithmen interpoliert wird, enthält eine 0</translation>
    </message>
    <message>
        <source>expected a map {0} of numbers, n {1} to {2}, not {3}</source>
        <translation>erwartet wurde eine Karte {0} von Zahlen, n {1} bis {2}, nicht {3}</translation>
    </message>
    <message>
        <source>holds a number that is negative or not finite</source>
        <translation>enthält eine Zahl, die negativ oder nicht endlich ist</translation>
    </message>
    <message>
        <source>expected at most {0} factors</source>
        <translation>erwartet wurden höchstens {0} Faktoren</translation>
    </message>
    <message>
        <source>The {0} failed: its values have the shape {1}, the directions {2}.</source>
        <translation>Das {0} ist fehlgeschlagen: Seine Werte haben die Form {1}, die Richtungen {2}.</translation>
    </message>
    <message>
        <source>expected a half-angle from 0 to {0}°, not {1}°</source>
        <translation>erwartet wurde ein Halbwinkel von 0 bis {0}°, nicht {1}°</translation>
    </message>
    <message>
        <source>no aperture (single directions)</source>
        <translation>keine Blende (einzelne Richtungen)</translation>
    </message>
    <message>
        <source>half-angles: light {0}°, receptor {1}°</source>
        <translation>Halbwinkel: Licht {0}°, Empfänger {1}°</translation>
    </message>
    <message>
        <source>{0} is neither a name ({1}) nor half-angles in degrees, RECEPTOR or LIGHT,RECEPTOR</source>
        <translation>{0} ist weder ein Name ({1}) noch Halbwinkel in Grad, EMPFÄNGER oder LICHT,EMPFÄNGER</translation>
    </message>
    <message>
        <source>a pixel sees no light: too few directions</source>
        <translation>ein Pixel sieht kein Licht: zu wenige Richtungen</translation>
    </message>
    <message>
        <source>The reflectance gives values that are not finite numbers at a gloss angle.</source>
        <translation>Die Reflexion ergibt bei einem Glanzwinkel Werte, die keine endlichen Zahlen sind.</translation>
    </message>
    <message>
        <source>{0}° (nearest {1}°)</source>
        <translation>{0}° (nächster {1}°)</translation>
    </message>
    <message>
        <source>{0} (nearest {1}°)</source>
        <translation>{0} (nächster {1}°)</translation>
    </message>
    <message>
        <source>No sample lies within {0}° of the readings at {1}.</source>
        <translation>Kein Messpunkt liegt innerhalb von {0}° von den Werten bei {1}.</translation>
    </message>
    <message>
        <source>The reflectance gives values that are not finite numbers at {0}.</source>
        <translation>Die Reflexion ergibt bei {0} Werte, die keine endlichen Zahlen sind.</translation>
    </message>
    <message>
        <source>At {0} the aperture reaches into the mirror direction.</source>
        <translation>Bei {0} reicht die Blende in die Spiegelrichtung.</translation>
    </message>
    <message>
        <source>At {0} the integral over the aperture is uncertain by {1} %.</source>
        <translation>Bei {0} ist das Integral über die Blende um {1} % unsicher.</translation>
    </message>
    <message>
        <source>Through the aperture the rule&apos;s own colours are met to ΔE00 {0}.</source>
        <translation>Durch die Blende werden die eigenen Farben der Regel auf ΔE00 {0} getroffen.</translation>
    </message>
    <message>
        <source>{0}: no paint reads these colours through {1}.</source>
        <translation>{0}: Kein Lack zeigt durch {1} diese Farben.</translation>
    </message>
    <message>
        <source>{0}: through {1}, no paint was found that reads the colour at {2}° to better than ΔE00 {3}; use a smaller aperture, or correct that reading.</source>
        <translation>{0}: Durch {1} wurde kein Lack gefunden, der die Farbe bei {2}° auf ΔE00 {3} genau zeigt; nehmen Sie eine kleinere Blende, oder berichtigen Sie diesen Messwert.</translation>
    </message>
    <message>
        <source>attributes are not allowed</source>
        <translation>Attribute sind nicht erlaubt</translation>
    </message>
    <message>
        <source>imports are not allowed</source>
        <translation>Importe sind nicht erlaubt</translation>
    </message>
    <message>
        <source>loops are not allowed</source>
        <translation>Schleifen sind nicht erlaubt</translation>
    </message>
    <message>
        <source>write a function by def</source>
        <translation>schreiben Sie eine Funktion mit def</translation>
    </message>
    <message>
        <source>functions call each other too deeply</source>
        <translation>Funktionen rufen einander zu tief auf</translation>
    </message>
    <message>
        <source>the text has too many formulas</source>
        <translation>der Text hat zu viele Formeln</translation>
    </message>
    <message>
        <source>decorators and annotations are not allowed</source>
        <translation>Dekoratoren und Annotationen sind nicht erlaubt</translation>
    </message>
    <message>
        <source>the function {0} is there already</source>
        <translation>die Funktion {0} gibt es schon</translation>
    </message>
    <message>
        <source>a function takes plain names</source>
        <translation>eine Funktion nimmt einfache Namen</translation>
    </message>
    <message>
        <source>return stands at the end, with a value</source>
        <translation>return steht am Ende, mit einem Wert</translation>
    </message>
    <message>
        <source>{0} returns nothing</source>
        <translation>{0} gibt nichts zurück</translation>
    </message>
    <message>
        <source>assign to one name at a time</source>
        <translation>weisen Sie jeweils nur einem Namen zu</translation>
    </message>
    <message>
        <source>the formula is nested too deeply; assign parts of it to names</source>
        <translation>die Formel ist zu tief verschachtelt; weisen Sie Teile davon Namen zu</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>erwartet wurde eine Zahl</translation>
    </message>
    <message>
        <source>there is no {0}</source>
        <translation>es gibt {0} nicht</translation>
    </message>
    <message>
        <source>a component is [0], [1] or [2]</source>
        <translation>eine Komponente ist [0], [1] oder [2]</translation>
    </message>
    <message>
        <source>only functions are called, with values in their order</source>
        <translation>aufgerufen werden nur Funktionen, mit Werten in deren Reihenfolge</translation>
    </message>
    <message>
        <source>there is no function {0} above this line</source>
        <translation>über dieser Zeile gibt es keine Funktion {0}</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} bis {1}</translation>
    </message>
    <message>
        <source>{0} takes {1} values, not {2}</source>
        <translation>{0} nimmt {1} Werte, nicht {2}</translation>
    </message>
    <message>
        <source>a function returns nothing</source>
        <translation>eine Funktion gibt nichts zurück</translation>
    </message>
    <message>
        <source>the formulas take more than {0} operations</source>
        <translation>die Formeln brauchen mehr als {0} Rechenschritte</translation>
    </message>
    <message>
        <source>Model text, GLSL</source>
        <translation>Modelltext, GLSL</translation>
    </message>
    <message>
        <source>Model text, Python’s notation</source>
        <translation>Modelltext, Schreibweise von Python</translation>
    </message>
    <message>
        <source>The text gives no finite value for {0} % of the directions; they are black.</source>
        <translation>Der Text ergibt für {0} % der Richtungen keinen endlichen Wert; sie sind schwarz.</translation>
    </message>
    <message>
        <source>computed in linear sRGB</source>
        <translation>in linearem sRGB berechnet</translation>
    </message>
    <message>
        <source>The model takes longer than {0} s for {1} pairs of directions.</source>
        <translation>Das Modell braucht länger als {0} s für {1} Richtungspaare.</translation>
    </message>
    <message>
        <source>The graphics driver broke down on this model.</source>
        <translation>Der Grafiktreiber ist an diesem Modell abgestürzt.</translation>
    </message>
    <message>
        <source>No process could be started for the model ({0}).</source>
        <translation>Für das Modell ließ sich kein Prozess starten ({0}).</translation>
    </message>
    <message>
        <source>minimum, maximum and default</source>
        <translation>Minimum, Maximum und Vorgabe</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 oder 1</translation>
    </message>
    <message>
        <source>three numbers from 0 to 1</source>
        <translation>drei Zahlen von 0 bis 1</translation>
    </message>
    <message>
        <source>the text has {0} characters, more than the {1} allowed</source>
        <translation>der Text hat {0} Zeichen, mehr als die erlaubten {1}</translation>
    </message>
    <message>
        <source>the text has a null character</source>
        <translation>der Text hat ein Nullzeichen</translation>
    </message>
    <message>
        <source>expected “::begin parameters” or “::begin shader”, each once</source>
        <translation>erwartet wurde „::begin parameters“ oder „::begin shader“, jedes einmal</translation>
    </message>
    <message>
        <source>there is no section {0}</source>
        <translation>es gibt keinen Abschnitt {0}</translation>
    </message>
    <message>
        <source>expected “::end {0}”</source>
        <translation>erwartet wurde „::end {0}“</translation>
    </message>
    <message>
        <source>nothing has begun</source>
        <translation>es hat kein Abschnitt begonnen</translation>
    </message>
    <message>
        <source>{0} stands in no section</source>
        <translation>{0} steht in keinem Abschnitt</translation>
    </message>
    <message>
        <source>“::end {0}” is missing</source>
        <translation>„::end {0}“ fehlt</translation>
    </message>
    <message>
        <source>{0} NAME with {1}</source>
        <translation>{0} NAME mit {1}</translation>
    </message>
    <message>
        <source>expected one of: {0}</source>
        <translation>erwartet wurde eines von: {0}</translation>
    </message>
    <message>
        <source>{0} cannot be the name of a parameter</source>
        <translation>{0} kann nicht der Name eines Parameters sein</translation>
    </message>
    <message>
        <source>the parameter {0} is declared twice</source>
        <translation>der Parameter {0} ist zweimal deklariert</translation>
    </message>
    <message>
        <source>more than {0} parameters</source>
        <translation>mehr als {0} Parameter</translation>
    </message>
    <message>
        <source>the parameter {0} needs {1}</source>
        <translation>der Parameter {0} braucht {1}</translation>
    </message>
    <message>
        <source>the formulas are nested too deeply ({0})</source>
        <translation>die Formeln sind zu tief verschachtelt ({0})</translation>
    </message>
    <message>
        <source>brdf takes L, V, N, X, Y, and then the parameters</source>
        <translation>brdf nimmt L, V, N, X, Y und dann die Parameter</translation>
    </message>
    <message>
        <source>{0}: expected a number</source>
        <translation>{0}: erwartet wurde eine Zahl</translation>
    </message>
    <message>
        <source>wi and wo</source>
        <translation>wi und wo</translation>
    </message>
    <message>
        <source>{0} and {1} do not broadcast</source>
        <translation>{0} und {1} passen in der Form nicht zusammen</translation>
    </message>
    <message>
        <source>expected directions of the shape (..., 3), not {0}</source>
        <translation>erwartet wurden Richtungen der Form (..., 3), nicht {0}</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>How far the base spreads light: 0 mirror, 1 matt</source>
        <translation>Wie weit die Basis Licht streut: 0 Spiegel, 1 matt</translation>
    </message>
    <message>
        <source>KD, f_r of the diffuse part, linear Rec. 2020</source>
        <translation>KD, f_r des diffusen Anteils, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Sharpness E of a lobe</source>
        <translation>Schärfe E einer Keule</translation>
    </message>
    <message>
        <source>KDD of a lobe, linear Rec. 2020</source>
        <translation>KDD einer Keule, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>KG of a lobe, linear Rec. 2020</source>
        <translation>KG einer Keule, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>expected a colour for each of {0} exponents, not {1}</source>
        <translation>erwartet wurde eine Farbe für jeden von {0} Exponenten, nicht {1}</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Fresnel reflectance along the normal, linear Rec. 2020</source>
        <translation>Fresnel-Reflexionsgrad entlang der Normalen, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>GGX width α</source>
        <translation>GGX-Breite α</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>f_r where the product is 1, linear Rec. 2020</source>
        <translation>f_r, wo das Produkt 1 ist, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Cx</source>
        <translation>Cx</translation>
    </message>
    <message>
        <source>Cy</source>
        <translation>Cy</translation>
    </message>
    <message>
        <source>Cz</source>
        <translation>Cz</translation>
    </message>
    <message>
        <source>Sharpness n of the lobe</source>
        <translation>Schärfe n der Keule</translation>
    </message>
    <message>
        <source>expected a lobe, not {0}</source>
        <translation>erwartet wurde eine Keule, nicht {0}</translation>
    </message>
    <message>
        <source>Share of the light reflected, linear Rec. 2020</source>
        <translation>Anteil des reflektierten Lichts, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Share in the lobe along the normal, linear Rec. 2020</source>
        <translation>Anteil in der Keule entlang der Normalen, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Diffuse reflectance of the base, linear Rec. 2020</source>
        <translation>Diffuse Reflexion der Basis, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Share in the base&apos;s lobe, linear Rec. 2020</source>
        <translation>Anteil in der Keule der Basis, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Flop exponent</source>
        <translation>Flop-Exponent</translation>
    </message>
    <message>
        <source>Sharpness n of the base&apos;s lobe</source>
        <translation>Schärfe n der Keule der Basis</translation>
    </message>
    <message>
        <source>Coat exponent</source>
        <translation>Klarlack-Exponent</translation>
    </message>
    <message>
        <source>Sharpness N of the coat&apos;s lobe</source>
        <translation>Schärfe N der Keule des Klarlacks</translation>
    </message>
    <message>
        <source>Matt reflectance of a facet, linear Rec. 2020</source>
        <translation>Matte Reflexion einer Facette, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Glossy reflectance of a facet, linear Rec. 2020</source>
        <translation>Glänzende Reflexion einer Facette, lineares Rec. 2020</translation>
    </message>
    <message>
        <source>Sharpness n of a facet&apos;s gloss</source>
        <translation>Schärfe n des Glanzes einer Facette</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>radii</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>Distance between the cylinders&apos; axes</source>
        <translation>Abstand zwischen den Achsen der Zylinder</translation>
    </message>
    <message>
        <source>Height of the floor above the axes</source>
        <translation>Höhe des Bodens über den Achsen</translation>
    </message>
    <message>
        <source>cylinders over a floor at {0} need at least {1}, not {2}</source>
        <translation>Zylinder über einem Boden bei {0} brauchen mindestens {1}, nicht {2}</translation>
    </message>
    <message>
        <source>Table 1 of Günther, Chen, Goesele, Wald and Seidel, Efficient Acquisition and Realistic Rendering of Car Paint, VMV 2005: three Cook-Torrance lobes fitted to measurements. The paper&apos;s own numbers; the colour channels of its camera are taken as linear Rec. 2020.</source>
        <translation>Tabelle 1 aus Günther, Chen, Goesele, Wald und Seidel, Efficient Acquisition and Realistic Rendering of Car Paint, VMV 2005: drei an Messungen angepasste Cook-Torrance-Keulen. Die Zahlen der Veröffentlichung; die Farbkanäle ihrer Kamera gelten als lineares Rec. 2020.</translation>
    </message>
    <message>
        <source>flake rule</source>
        <translation>Flake-Regel</translation>
    </message>
    <message>
        <source>monotone rule</source>
        <translation>monotone Regel</translation>
    </message>
    <message>
        <source>polynomial rule</source>
        <translation>Polynomregel</translation>
    </message>
    <message>
        <source>flake rule by the half vector&apos;s tilt</source>
        <translation>Flake-Regel nach der Neigung des Halbvektors</translation>
    </message>
    <message>
        <source>two light angles</source>
        <translation>zwei Lichtwinkel</translation>
    </message>
    <message>
        <source>aspecular{0}</source>
        <translation>aspecular{0}</translation>
    </message>
    <message>
        <source>Aspecular paint, {0}</source>
        <translation>Aspekularer Lack, {0}</translation>
    </message>
    <message>
        <source>Westlund and Meyer 2001; Shimizu, Meyer and Wingard 2003</source>
        <translation>Westlund und Meyer 2001; Shimizu, Meyer und Wingard 2003</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>Klarlack</translation>
    </message>
    <message>
        <source>Clearcoat alone</source>
        <translation>Klarlack allein</translation>
    </message>
    <message>
        <source>Beckmann; Walter et al. 2007</source>
        <translation>Beckmann; Walter u. a. 2007</translation>
    </message>
    <message>
        <source>Matt base under a clearcoat</source>
        <translation>Matte Basis unter Klarlack</translation>
    </message>
    <message>
        <source>Saunderson 1942</source>
        <translation>Saunderson 1942</translation>
    </message>
    <message>
        <source>Phong with a clearcoat by Fresnel</source>
        <translation>Phong mit Klarlack nach Fresnel</translation>
    </message>
    <message>
        <source>after Günther et al. 2005, section 6.1</source>
        <translation>nach Günther u. a. 2005, Abschnitt 6.1</translation>
    </message>
    <message>
        <source>Cook-Torrance, three lobes (Polaris Silver)</source>
        <translation>Cook-Torrance, drei Keulen (Polarissilber)</translation>
    </message>
    <message>
        <source>Günther et al. 2005, equation 1 and Table 1</source>
        <translation>Günther u. a. 2005, Gleichung 1 und Tabelle 1</translation>
    </message>
    <message>
        <source>Sum of cosine lobes</source>
        <translation>Summe von Kosinuskeulen</translation>
    </message>
    <message>
        <source>BRDF approximation for interactive colour appearance design, equations 1 to 3</source>
        <translation>BRDF approximation for interactive colour appearance design, Gleichungen 1 bis 3</translation>
    </message>
    <message>
        <source>factored</source>
        <translation>faktorisiert</translation>
    </message>
    <message>
        <source>Product of textures, light × half vector × view</source>
        <translation>Produkt von Texturen, Licht × Halbvektor × Blick</translation>
    </message>
    <message>
        <source>McCool, Ang and Ahmad 2001</source>
        <translation>McCool, Ang und Ahmad 2001</translation>
    </message>
    <message>
        <source>Product of radial textures with a peak apart</source>
        <translation>Produkt radialer Texturen mit abgetrennter Spitze</translation>
    </message>
    <message>
        <source>McCool, Ang and Ahmad 2001, sections 4.2 and 4.3</source>
        <translation>McCool, Ang und Ahmad 2001, Abschnitte 4.2 und 4.3</translation>
    </message>
    <message>
        <source>ggx</source>
        <translation>ggx</translation>
    </message>
    <message>
        <source>GGX metal over a matt part</source>
        <translation>GGX-Metall über einem matten Anteil</translation>
    </message>
    <message>
        <source>Walter et al. 2007; Heitz 2014</source>
        <translation>Walter u. a. 2007; Heitz 2014</translation>
    </message>
    <message>
        <source>GGX metal under a clearcoat</source>
        <translation>GGX-Metall unter Klarlack</translation>
    </message>
    <message>
        <source>Walter et al. 2007</source>
        <translation>Walter u. a. 2007</translation>
    </message>
    <message>
        <source>lafortune</source>
        <translation>lafortune</translation>
    </message>
    <message>
        <source>Generalised cosine lobes</source>
        <translation>Verallgemeinerte Kosinuskeulen</translation>
    </message>
    <message>
        <source>Lafortune et al. 1997</source>
        <translation>Lafortune u. a. 1997</translation>
    </message>
    <message>
        <source>lambertian</source>
        <translation>lambertian</translation>
    </message>
    <message>
        <source>Matt</source>
        <translation>Matt</translation>
    </message>
    <message>
        <source>Lambert 1760</source>
        <translation>Lambert 1760</translation>
    </message>
    <message>
        <source>phong</source>
        <translation>phong</translation>
    </message>
    <message>
        <source>Phong, modified</source>
        <translation>Phong, abgewandelt</translation>
    </message>
    <message>
        <source>Lewis 1994</source>
        <translation>Lewis 1994</translation>
    </message>
    <message>
        <source>Phong, original</source>
        <translation>Phong, ursprünglich</translation>
    </message>
    <message>
        <source>original</source>
        <translation>ursprünglich</translation>
    </message>
    <message>
        <source>Phong 1975</source>
        <translation>Phong 1975</translation>
    </message>
    <message>
        <source>Brushed metal of cylinders</source>
        <translation>Gebürstetes Metall aus Zylindern</translation>
    </message>
    <message>
        <source>Poulin and Fournier 1990</source>
        <translation>Poulin und Fournier 1990</translation>
    </message>
    <message>
        <source>must be two or more angles that rise, from 0 to π/2</source>
        <translation>müssen zwei oder mehr steigende Winkel von 0 bis π/2 sein</translation>
    </message>
    <message>
        <source>has the shape {0}; expected {1}</source>
        <translation>hat die Form {0}; erwartet wurde {1}</translation>
    </message>
    <message>
        <source>has {0} and {1} azimuths; as many of both</source>
        <translation>hat {0} und {1} Azimute; von beiden gleich viele</translation>
    </message>
    <message>
        <source>is not finite or is negative; a reflectance is neither</source>
        <translation>ist nicht endlich oder negativ; eine Reflexion ist beides nicht</translation>
    </message>
    <message>
        <source>differs from theta_i, so no node is another&apos;s swap</source>
        <translation>weicht von theta_i ab, kein Knoten ist also der Tausch eines anderen</translation>
    </message>
    <message>
        <source>{0} bins; 2 along each axis to {1} in all are held</source>
        <translation>{0} Felder; gespeichert werden 2 entlang jeder Achse bis insgesamt {1}</translation>
    </message>
    <message>
        <source>has the shape {0}; expected (θh, θd, φd), alike for both</source>
        <translation>hat die Form {0}; erwartet wurde (θh, θd, φd), für beide gleich</translation>
    </message>
    <message>
        <source>has the shape {0}; expected (θh, θd, φd, 3)</source>
        <translation>hat die Form {0}; erwartet wurde (θh, θd, φd, 3)</translation>
    </message>
    <message>
        <source>φd has {0} bins; expected an even number</source>
        <translation>φd hat {0} Felder; erwartet wurde eine gerade Anzahl</translation>
    </message>
    <message>
        <source>holds no sample; expected at least one</source>
        <translation>enthält keinen Messpunkt; erwartet wurde mindestens einer</translation>
    </message>
    <message>
        <source>is not a unit direction above the horizon</source>
        <translation>ist keine Einheitsrichtung über dem Horizont</translation>
    </message>
    <message>
        <source>holds {0} directions where wi holds {1}</source>
        <translation>enthält {0} Richtungen, wi enthält {1}</translation>
    </message>
    <message>
        <source>spectra and wavelengths_nm come together or not at all</source>
        <translation>spectra und wavelengths_nm kommen zusammen oder gar nicht</translation>
    </message>
    <message>
        <source>must be positive and rise</source>
        <translation>müssen positiv sein und steigen</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>these samples hold colours only, no spectra</source>
        <translation>diese Messpunkte enthalten nur Farben, keine Spektren</translation>
    </message>
    <message>
        <source>is negative; a reflectance is not</source>
        <translation>ist negativ; eine Reflexion ist es nicht</translation>
    </message>
    <message>
        <source>gives values that are not finite</source>
        <translation>ergibt Werte, die nicht endlich sind</translation>
    </message>
    <message>
        <source>changes when the sample is turned; only isotropic reflectances are written in this format</source>
        <translation>ändert sich, wenn die Probe gedreht wird; in diesem Format werden nur isotrope Reflexionen geschrieben</translation>
    </message>
    <message>
        <source>light probe: the angle from the middle (-z) grows evenly with the radius</source>
        <translation>Lichtsonde: Der Winkel von der Mitte (-z) wächst gleichmäßig mit dem Radius</translation>
    </message>
    <message>
        <source>photograph of a mirror ball from far away, the camera at -z</source>
        <translation>Foto einer Spiegelkugel aus großer Entfernung, die Kamera bei -z</translation>
    </message>
    <message>
        <source>must be one or more angles that rise</source>
        <translation>müssen ein oder mehr steigende Winkel sein</translation>
    </message>
    <message>
        <source>this table holds colours only, no spectra</source>
        <translation>diese Tabelle enthält nur Farben, keine Spektren</translation>
    </message>
    <message>
        <source>on a test grid</source>
        <translation>auf einem Prüfraster</translation>
    </message>
    <message>
        <source>this material was measured in RGB, it has no spectra</source>
        <translation>dieses Material wurde in RGB gemessen, es hat keine Spektren</translation>
    </message>
    <message>
        <source>it is a link to a file that is not there</source>
        <translation>es ist ein Verweis auf eine Datei, die es nicht gibt</translation>
    </message>
    <message>
        <source>holds {0} paints; a sheet takes {1}</source>
        <translation>enthält {0} Lacke; ein Blatt nimmt {1}</translation>
    </message>
    <message>
        <source>there is no paint to draw</source>
        <translation>es gibt keinen Lack zum Zeichnen</translation>
    </message>
    <message>
        <source>sheets are written as PNG of 8 bits or as PDF; give a name that ends in .png or .pdf</source>
        <translation>Blätter werden als PNG mit 8 Bit oder als PDF geschrieben; geben Sie einen Namen an, der auf .png oder .pdf endet</translation>
    </message>
    <message>
        <source>1 to {0} stand in a row, not {1}</source>
        <translation>in einer Reihe stehen 1 bis {0}, nicht {1}</translation>
    </message>
    <message>
        <source>a PDF has pictures in sRGB; leave the colour space out</source>
        <translation>ein PDF hat Bilder in sRGB; lassen Sie den Farbraum weg</translation>
    </message>
    <message>
        <source>{0} are known, not {1}</source>
        <translation>bekannt sind {0}, nicht {1}</translation>
    </message>
    <message>
        <source>{0}, {1} of {2}</source>
        <translation>{0}, {1} von {2}</translation>
    </message>
    <message>
        <source>There is no format {0}; there are {1}.</source>
        <translation>Es gibt kein Format {0}; es gibt {1}.</translation>
    </message>
    <message>
        <source>the ending {0} names no format ({1}); name one by --format</source>
        <translation>die Endung {0} nennt kein Format ({1}); nennen Sie eines mit --format</translation>
    </message>
    <message>
        <source>Measured file {0}.</source>
        <translation>Messdatei {0}.</translation>
    </message>
    <message>
        <source>{0}: what is read of it makes no paint: {1}</source>
        <translation>{0}: Was davon gelesen wurde, ergibt keinen Lack: {1}</translation>
    </message>
    <message>
        <source>at least one is wanted</source>
        <translation>verlangt ist mindestens eines</translation>
    </message>
    <message>
        <source>a file of {0} takes one paint, not {1}</source>
        <translation>eine Datei im Format {0} nimmt einen Lack, nicht {1}</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>wird gelesen</translation>
    </message>
    <message>
        <source>reading texture</source>
        <translation>Textur wird abgelesen</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>wird geschrieben</translation>
    </message>
    <message>
        <source>Page and pictures are for people; programs read the paint from the data that goes along with it.</source>
        <translation>Seite und Bilder sind für Menschen; Programme lesen den Lack aus den Daten, die darin stehen.</translation>
    </message>
    <message>
        <source>One page with pictures, plots and numbers; the paint itself is attached as a file.</source>
        <translation>Eine Seite mit Bildern, Diagrammen und Zahlen; der Lack selbst liegt als Datei bei.</translation>
    </message>
    <message>
        <source>holds no paint of this suite that can be found; another program may have packed it</source>
        <translation>enthält keinen auffindbaren Lack dieser Suite; ein anderes Programm kann sie umgepackt haben</translation>
    </message>
    <message>
        <source>One page with pictures, plots and numbers; the paint itself goes along as data.</source>
        <translation>Eine Seite mit Bildern, Diagrammen und Zahlen; der Lack selbst steht als Daten darin.</translation>
    </message>
    <message>
        <source>the packaged resources are missing; install brdf-suite again</source>
        <translation>die mitgelieferten Dateien fehlen; installieren Sie brdf-suite neu</translation>
    </message>
    <message>
        <source>there is no such {0} among the packaged ones ({1})</source>
        <translation>unter den mitgelieferten gibt es keine solche Datei: {0} ({1})</translation>
    </message>
    <message>
        <source>The name of the {0} is empty; give a file or a shipped one ({1}).</source>
        <translation>Der Name ist leer: {0}; geben Sie eine Datei an, oder Mitgeliefertes ({1}).</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such file, nor a shipped {0} of that name{1}</source>
        <translation>diese Datei gibt es nicht, und auch nichts Mitgeliefertes dieses Namens: {0}{1}</translation>
    </message>
    <message>
        <source>`brdf-suite list {0}s` names all {1}</source>
        <translation>`brdf-suite list {0}s` nennt alle {1}</translation>
    </message>
    <message>
        <source>the documents are missing; install brdf-suite again</source>
        <translation>die Dokumente fehlen; installieren Sie brdf-suite neu</translation>
    </message>
    <message>
        <source>there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)</source>
        <translation>es gibt keinen Bildschirm (weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt)</translation>
    </message>
    <message>
        <source>there is no screen (nothing answers at {0})</source>
        <translation>es gibt keinen Bildschirm (unter {0} antwortet nichts)</translation>
    </message>
    <message>
        <source>the name is empty</source>
        <translation>der Name ist leer</translation>
    </message>
    <message>
        <source>{0}, {1} and {2}</source>
        <translation>{0}, {1} und {2}</translation>
    </message>
    <message>
        <source>{0} positions, normals and uvs, which must be equal in number</source>
        <translation>{0} Positionen, Normalen und Texturkoordinaten, deren Anzahl gleich sein muss</translation>
    </message>
    <message>
        <source>length {0}, not 1</source>
        <translation>Länge {0}, nicht 1</translation>
    </message>
    <message>
        <source>part {0}, {1}</source>
        <translation>Teil {0}, {1}</translation>
    </message>
    <message>
        <source>type {0}, not real numbers</source>
        <translation>Typ {0}, keine reellen Zahlen</translation>
    </message>
    <message>
        <source>shape {0}, not (n, {1}) with n of at least 3</source>
        <translation>Form {0}, nicht (n, {1}) mit n von mindestens 3</translation>
    </message>
    <message>
        <source>not a finite single-precision number</source>
        <translation>keine endliche Zahl einfacher Genauigkeit</translation>
    </message>
    <message>
        <source>type {0}, not integers</source>
        <translation>Typ {0}, keine ganzen Zahlen</translation>
    </message>
    <message>
        <source>shape {0}, not (k, 3) with k of at least 1</source>
        <translation>Form {0}, nicht (k, 3) mit k von mindestens 1</translation>
    </message>
    <message>
        <source>an index outside 0 to {0}</source>
        <translation>ein Index außerhalb von 0 bis {0}</translation>
    </message>
    <message>
        <source>no part</source>
        <translation>kein Teil</translation>
    </message>
    <message>
        <source>occlusion: sorting the triangles</source>
        <translation>Umgebungsverdeckung: Dreiecke werden sortiert</translation>
    </message>
    <message>
        <source>Occlusion cannot be baked: the ray tracer Embree is not there for this machine ({0}).</source>
        <translation>Die Umgebungsverdeckung lässt sich nicht berechnen: Embree, das Strahlen verfolgt, gibt es für diesen Rechner nicht ({0}).</translation>
    </message>
    <message>
        <source>occlusion of the surface</source>
        <translation>Umgebungsverdeckung der Oberfläche</translation>
    </message>
    <message>
        <source>fitting the occlusion</source>
        <translation>Umgebungsverdeckung wird angepasst</translation>
    </message>
    <message>
        <source>occlusion of the floor</source>
        <translation>Umgebungsverdeckung des Bodens</translation>
    </message>
    <message>
        <source>{0}: turned inside out, its triangles faced inwards</source>
        <translation>{0}: umgestülpt, die Dreiecke zeigten nach innen</translation>
    </message>
    <message>
        <source>{0}: had no normals; made smooth, with edges above {1}°</source>
        <translation>{0}: hatte keine Normalen; geglättet, mit Kanten über {1}°</translation>
    </message>
    <message>
        <source>had no texture coordinates</source>
        <translation>hatte keine Texturkoordinaten</translation>
    </message>
    <message>
        <source>texture coordinates were too uneven for flakes</source>
        <translation>Texturkoordinaten waren zu ungleichmäßig für Flakes</translation>
    </message>
    <message>
        <source>{0}: {1}; projected from the sides of a box, in millimetres</source>
        <translation>{0}: {1}; von den Seiten eines Kastens projiziert, in Millimetern</translation>
    </message>
    <message>
        <source>{0}: left out {1} with corners that are not in the file</source>
        <translation>{0}: {1} mit Ecken, die nicht in der Datei sind, ausgelassen</translation>
    </message>
    <message>
        <source>{0}: left out {1} with corners that are not finite</source>
        <translation>{0}: {1} mit nicht endlichen Ecken ausgelassen</translation>
    </message>
    <message>
        <source>{0}: left out {1} without area</source>
        <translation>{0}: {1} ohne Fläche ausgelassen</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 Dreieck</translation>
    </message>
    <message>
        <source>{0} triangles</source>
        <translation>{0} Dreiecke</translation>
    </message>
    <message>
        <source>{0}: made {1} normals that were missing or not finite</source>
        <translation>{0}: {1} Normalen erzeugt, die fehlten oder nicht endlich waren</translation>
    </message>
    <message>
        <source>Without LLVM there are no single flakes, no relief and no mask: the first paint is shown there, smooth.</source>
        <translation>Ohne LLVM gibt es keine einzelnen Flakes, kein Relief und keine Maske: Dort ist der erste Lack zu sehen, glatt.</translation>
    </message>
    <message>
        <source>Without LLVM there is no ground and no shadow on it.</source>
        <translation>Ohne LLVM gibt es keinen Boden und keinen Schatten darauf.</translation>
    </message>
    <message>
        <source>pictures are written as PNG or EXR; give a name that ends in .png or .exr</source>
        <translation>Bilder werden als PNG oder EXR geschrieben; geben Sie einen Namen an, der auf .png oder .exr endet</translation>
    </message>
    <message>
        <source>starting the ray tracer</source>
        <translation>Strahlverfolger startet</translation>
    </message>
    <message>
        <source>{0} of {1} samples</source>
        <translation>{0} von {1} Abtastwerten</translation>
    </message>
    <message>
        <source>{0}, {1} left</source>
        <translation>{0}, noch {1}</translation>
    </message>
    <message>
        <source>{0} min</source>
        <translation>{0} min</translation>
    </message>
    <message>
        <source>{0} h {1} min</source>
        <translation>{0} h {1} min</translation>
    </message>
    <message>
        <source>{0} on {1} in {2}, ray-traced with {3} lights, {4} reflected rays and {5} samples a pixel, {6} EV, tone curve {7}</source>
        <translation>{0} auf {1} in {2}, strahlverfolgt mit {3} Lichtern, {4} reflektierten Strahlen und {5} Abtastwerten je Pixel, {6} EV, Tonwertkurve {7}</translation>
    </message>
    <message>
        <source>Nothing has been shown to the ray tracer yet.</source>
        <translation>Dem Strahlverfolger wurde noch nichts gezeigt.</translation>
    </message>
    <message>
        <source>building the scene</source>
        <translation>Szene wird aufgebaut</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>The ray tracer shows a smooth surface, without normal map and orange peel.</source>
        <translation>Der Strahlverfolger zeigt eine glatte Oberfläche, ohne Normalenkarte und Orangenhaut.</translation>
    </message>
    <message>
        <source>The ray tracer shows the first paint alone where the mask divides two.</source>
        <translation>Der Strahlverfolger zeigt nur den ersten Lack, wo die Maske zwei teilt.</translation>
    </message>
    <message>
        <source>The ray tracer shows all sharp: without depth of field, and without the blur of a turn.</source>
        <translation>Der Strahlverfolger zeigt alles scharf: ohne Schärfentiefe und ohne die Unschärfe einer Drehung.</translation>
    </message>
    <message>
        <source>times the light that falls on it</source>
        <translation>mal so viel wie das einfallende Licht</translation>
    </message>
    <message>
        <source>second paint</source>
        <translation>zweiter Lack</translation>
    </message>
    <message>
        <source>term of {0}</source>
        <translation>Anteil von {0}</translation>
    </message>
    <message>
        <source>cut of {0}</source>
        <translation>Schnitt von {0}</translation>
    </message>
    <message>
        <source>This paint would reflect {0} {1}.</source>
        <translation>Dieser Lack würde reflektieren: {0} {1}.</translation>
    </message>
    <message>
        <source>Nothing has been shown to the path tracer yet.</source>
        <translation>Dem Pfadverfolger wurde noch nichts gezeigt.</translation>
    </message>
    <message>
        <source>Nothing has been traced yet.</source>
        <translation>Noch wurde nichts verfolgt.</translation>
    </message>
    <message>
        <source>the EXR of a traced picture holds what a render goes on from, in 32 bits and Rec. 2020; leave out --bits and --colour-space</source>
        <translation>das EXR eines verfolgten Bildes enthält, womit das Zeichnen fortgesetzt wird, in 32 Bit und Rec. 2020; lassen Sie --bits und --colour-space weg</translation>
    </message>
    <message>
        <source>{0} on {1} in {2}, path-traced with {3} samples a pixel, denoised, {4} EV, tone curve {5}</source>
        <translation>{0} auf {1} in {2}, pfadverfolgt mit {3} Abtastwerten je Pixel, entrauscht, {4} EV, Tonwertkurve {5}</translation>
    </message>
    <message>
        <source>{0} on {1} in {2}, path-traced with {3} samples a pixel, {4} EV, tone curve {5}</source>
        <translation>{0} auf {1} in {2}, pfadverfolgt mit {3} Abtastwerten je Pixel, {4} EV, Tonwertkurve {5}</translation>
    </message>
    <message>
        <source>, denoised</source>
        <translation>, entrauscht</translation>
    </message>
    <message>
        <source>{0} reflects amounts that are negative or not finite, so no light can be traced in it; brdf-suite check says where.</source>
        <translation>{0} reflektiert Beträge, die negativ oder nicht endlich sind, daher lässt sich kein Licht darin verfolgen; brdf-suite check zeigt, wo.</translation>
    </message>
    <message>
        <source>{0} reflects an endless amount of light at {1}°.</source>
        <translation>{0} reflektiert bei {1}° unendlich viel Licht.</translation>
    </message>
    <message>
        <source>{0} sends back {1} % of the {2} light that arrives at {3}°, more than there is. It is traced as it stands; where the surface sees itself, light grows with each reflection.</source>
        <translation>{0} wirft {1} % des Lichts zurück, {2}, das bei {3}° ankommt, mehr als vorhanden. Es wird so verfolgt, wie es ist; wo die Oberfläche sich selbst sieht, wächst das Licht mit jeder Reflexion.</translation>
    </message>
    <message>
        <source>starting the path tracer</source>
        <translation>Pfadverfolger startet</translation>
    </message>
    <message>
        <source>reading the environment</source>
        <translation>Umgebung wird gelesen</translation>
    </message>
    <message>
        <source>The reference shows the paint with its own reflection towards grazing: Fresnel is part of it.</source>
        <translation>Die Referenz zeigt den Lack mit seiner eigenen Reflexion zum streifenden Winkel: Fresnel ist ein Teil davon.</translation>
    </message>
    <message>
        <source>The reference always shows the shadows of the surface on itself.</source>
        <translation>Die Referenz zeigt immer die Schatten der Oberfläche auf sich selbst.</translation>
    </message>
    <message>
        <source>reading the paint</source>
        <translation>Lack wird gelesen</translation>
    </message>
    <message>
        <source>There is not enough memory to trace {0} × {1} pixels; make the picture smaller.</source>
        <translation>Der Speicher reicht nicht, um {0} × {1} Pixel zu verfolgen; verkleinern Sie das Bild.</translation>
    </message>
    <message>
        <source>starting the renderer</source>
        <translation>Renderer startet</translation>
    </message>
    <message>
        <source>, {0} s left</source>
        <translation>, noch {0} s</translation>
    </message>
    <message>
        <source>frame {0} of {1}{2}</source>
        <translation>Bild {0} von {1}{2}</translation>
    </message>
    <message>
        <source>writing the video</source>
        <translation>Video wird geschrieben</translation>
    </message>
    <message>
        <source>cannot be emptied: {0}</source>
        <translation>lässt sich nicht leeren: {0}</translation>
    </message>
    <message>
        <source>shaders of {0}: {1}</source>
        <translation>Shader von {0}: {1}</translation>
    </message>
    <message>
        <source>is not a font that can be loaded; install brdf-suite again</source>
        <translation>ist keine Schrift, die sich laden lässt; installieren Sie brdf-suite neu</translation>
    </message>
    <message>
        <source>the list of the gallery cannot be read ({0})</source>
        <translation>die Liste der Galerie ist nicht lesbar ({0})</translation>
    </message>
    <message>
        <source>the command ended with status {0}.</source>
        <translation>der Befehl endete mit Status {0}.</translation>
    </message>
    <message>
        <source>has {0}×{1} pixels, the photographs {2}×{3}</source>
        <translation>hat {0}×{1} Pixel, die Fotos {2}×{3}</translation>
    </message>
    <message>
        <source>autosave</source>
        <translation>wird automatisch gesichert</translation>
    </message>
    <message>
        <source>The paint could not be exported: {0}</source>
        <translation>Der Lack ließ sich nicht exportieren: {0}</translation>
    </message>
    <message>
        <source>looking for paints</source>
        <translation>Lacke werden gesucht</translation>
    </message>
    <message>
        <source>checking the values</source>
        <translation>Werte werden geprüft</translation>
    </message>
    <message>
        <source>building paints</source>
        <translation>Lacke werden aufgebaut</translation>
    </message>
    <message>
        <source>reading the light</source>
        <translation>Licht wird gelesen</translation>
    </message>
    <message>
        <source>preparing the scene</source>
        <translation>Szene wird vorbereitet</translation>
    </message>
    <message>
        <source>is no scene of this program ({0})</source>
        <translation>ist keine Szene dieses Programms ({0})</translation>
    </message>
    <message>
        <source>There is no picture yet</source>
        <translation>Es gibt noch kein Bild</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Ist kein Ordner</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei existiert bereits</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Auf dem Gerät ist kein Platz mehr frei</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Das Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} und {1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} oder {1}</translation>
    </message>
    <message>
        <source>flakes</source>
        <translation>Flakes</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Model Text</source>
        <translation>Modelltext</translation>
    </message>
    <message>
        <source>Write a reflectance model as GLSL or as formulas, with sliders for its parameters</source>
        <translation>Ein Reflexionsmodell als GLSL oder als Formeln schreiben, mit Reglern für seine Parameter</translation>
    </message>
    <message>
        <source>Model &amp;Text</source>
        <translation>Modell&amp;text</translation>
    </message>
    <message>
        <source>Model {number}</source>
        <translation>Modell {number}</translation>
    </message>
    <message>
        <source>The selected reflectance has no text. Start a model by New, or open a file.</source>
        <translation>Die ausgewählte Reflexion hat keinen Text. Beginnen Sie ein Modell mit „Neu“, oder öffnen Sie eine Datei.</translation>
    </message>
    <message>
        <source>No errors.</source>
        <translation>Keine Fehler.</translation>
    </message>
    <message>
        <source>“{name}” was removed with unsaved changes.</source>
        <translation>„{name}“ wurde mit ungespeicherten Änderungen entfernt.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Models of plug-ins</source>
        <translation>Modelle aus Plug-ins</translation>
    </message>
    <message>
        <source>Everything else works without it. `brdf-suite list plugins` lists all.</source>
        <translation>Alles andere funktioniert ohne es. `brdf-suite list plugins` listet alle auf.</translation>
    </message>
    <message>
        <source>GLSL, as in the BRDF Explorer</source>
        <translation>GLSL, wie im BRDF Explorer</translation>
    </message>
    <message>
        <source>Formulas in Python&apos;s notation</source>
        <translation>Formeln in der Schreibweise von Python</translation>
    </message>
    <message>
        <source>Start a model from an example</source>
        <translation>Ein Modell aus einem Beispiel beginnen</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Open a model&apos;s text (.brdf, .py)</source>
        <translation>Den Text eines Modells öffnen (.brdf, .py)</translation>
    </message>
    <message>
        <source>Save the text (Ctrl+S in the text)</source>
        <translation>Den Text speichern (Strg+S im Text)</translation>
    </message>
    <message>
        <source>Save the text under another name</source>
        <translation>Den Text unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Write the sliders&apos; values into the text, as the defaults of its parameters</source>
        <translation>Die Werte der Regler als Vorgaben der Parameter in den Text schreiben</translation>
    </message>
    <message>
        <source>Values to Text</source>
        <translation>Werte in den Text</translation>
    </message>
    <message>
        <source>Text of the model</source>
        <translation>Text des Modells</translation>
    </message>
    <message>
        <source>Start a model by New, or open a file.</source>
        <translation>Beginnen Sie ein Modell mit „Neu“, oder öffnen Sie eine Datei.</translation>
    </message>
    <message>
        <source>{name}, {channel}</source>
        <translation>{name}, {channel}</translation>
    </message>
    <message>
        <source>sRGB; the window system does not manage colour</source>
        <translation>sRGB; das Fenstersystem hat keine Farbverwaltung</translation>
    </message>
    <message>
        <source>Monitor profile: {title} (look-up tables)</source>
        <translation>Monitorprofil: {title} (Tabellen)</translation>
    </message>
    <message>
        <source>has a curve with the exponent {0}; expected above 0 and up to {1}</source>
        <translation>hat eine Kurve mit dem Exponenten {0}; erwartet wurde mehr als 0 bis {1}</translation>
    </message>
    <message>
        <source>expected n by n by n by 3, not {0}</source>
        <translation>erwartet wurde n mal n mal n mal 3, nicht {0}</translation>
    </message>
    <message>
        <source>expected a table or codes, not both</source>
        <translation>erwartet wurde eine Tabelle oder Codes, nicht beides</translation>
    </message>
    <message>
        <source>has no {0}; expected a matrix with curves, or the tables A2B0 and B2A0</source>
        <translation>hat kein {0}; erwartet wurde eine Matrix mit Kurven oder die Tabellen A2B0 und B2A0</translation>
    </message>
    <message>
        <source>is not of a monitor</source>
        <translation>gehört nicht zu einem Monitor</translation>
    </message>
    <message>
        <source>has channels that do not add up to white</source>
        <translation>hat Kanäle, die zusammen kein Weiß ergeben</translation>
    </message>
    <message>
        <source>has channels of impossible colours</source>
        <translation>hat Kanäle mit unmöglichen Farben</translation>
    </message>
    <message>
        <source>has tables that cannot be used ({0})</source>
        <translation>hat Tabellen, die nicht verwendbar sind ({0})</translation>
    </message>
    <message>
        <source>has a table of a kind that is not known</source>
        <translation>hat eine Tabelle unbekannter Art</translation>
    </message>
    <message>
        <source>has a table of {0} channels to {1}, not 3 to 3</source>
        <translation>hat eine Tabelle von {0} Kanälen nach {1}, nicht von 3 nach 3</translation>
    </message>
    <message>
        <source>is cut off in a table</source>
        <translation>ist in einer Tabelle abgeschnitten</translation>
    </message>
    <message>
        <source>has a table without points</source>
        <translation>hat eine Tabelle ohne Punkte</translation>
    </message>
    <message>
        <source>Choose CM&amp;YK Profile…</source>
        <translation>CM&amp;YK-Profil wählen …</translation>
    </message>
    <message>
        <source>Show the CMYK colours of this palette, and of those opened later, through an ICC profile</source>
        <translation>Die CMYK-Farben dieser und später geöffneter Paletten durch ein ICC-Profil zeigen</translation>
    </message>
    <message>
        <source>Forget CMYK Profile</source>
        <translation>CMYK-Profil vergessen</translation>
    </message>
    <message>
        <source>Show the CMYK colours of palettes opened later without a profile</source>
        <translation>Die CMYK-Farben später geöffneter Paletten ohne Profil zeigen</translation>
    </message>
    <message>
        <source>ICC profiles</source>
        <translation>ICC-Profile</translation>
    </message>
    <message>
        <source>The palette is unchanged. Choose another profile.</source>
        <translation>Die Palette ist unverändert. Wählen Sie ein anderes Profil.</translation>
    </message>
    <message>
        <source>Choose CMYK profile</source>
        <translation>CMYK-Profil wählen</translation>
    </message>
    <message>
        <source>All CMYK colours of this palette have a look of their own, which they keep.</source>
        <translation>Alle CMYK-Farben dieser Palette haben ein eigenes Aussehen und behalten es.</translation>
    </message>
    <message>
        <source>The CMYK profile {name} cannot be used: {reason}.</source>
        <translation>Das CMYK-Profil {name} kann nicht verwendet werden: {reason}.</translation>
    </message>
</context>
</TS>
