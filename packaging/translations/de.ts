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
        <source>{file}, at {place}</source>
        <translation>{file}, bei {place}</translation>
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
        <translation>Rauheit α des Klarlacks: Streuung der Facettenneigungen (Beckmann). Ein neues Auto hat 0.003, seidenmatt ist 0.05. Eine Änderung ändert beide Glanzwerte.</translation>
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
        <translation>Flop-Index 2,69 (L*15 − L*110)^1.11 / L*45^0.86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop. Er braucht Werte bei 15, 45 und 110°.</translation>
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
        <translation>Das verfolgte Bild speichern</translation>
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
        <translation>Streuung der Flake-Neigungen, als quadratisches Mittel der Steigung m: etwa 0.15 bis 0.19 für Metalliclacke. Breitere Streuung glitzert an mehr Winkeln und an jedem weniger.</translation>
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
2.69 (L*15 − L*110)^1.11 / L*45^0.86: 0 für eine Unifarbe, etwa 15 bis 17 für sehr hohen Flop.
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
        <translation>Weitere Variationen</translation>
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
        <source>Residual (pixels)</source>
        <translation>Residuum (Pixel)</translation>
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
        <translation>keine Pixel ausgeschlossen</translation>
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
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Undo the last stroke (Ctrl+Z)</source>
        <translation>Den letzten Strich zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wieder</translation>
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
        <translation>Rundgang beenden</translation>
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
        <translation>Alle Schritte tun</translation>
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
        <translation>Keulenanpassung…</translation>
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
        <source>Maximum away from R</source>
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
        <translation>Flop-Index 2,69 (L*15 − L*110)^1.11 / L*45^0.86; 0 für eine Unifarbe</translation>
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
        <translation>&amp;Verfolgtes Bild speichern …</translation>
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
        <translation>Es gibt noch kein verfolgtes Bild: im Reiter Export „Strahlverfolgt“ oder „Pfadverfolgt“ wählen</translation>
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
        <translation>Verfolgtes Bild</translation>
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
        <source>A palette, or a folder of paints</source>
        <translation>Eine Palette oder ein Ordner mit Lacken</translation>
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
        <source>Fit ΔE {worst}</source>
        <translation>Anpassung ΔE {worst}</translation>
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
</context>
</TS>
