<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Manual</name>
    <message>
        <source>More</source>
        <translation>Weiteres</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>Nachschlagen: %1</translation>
    </message>
    <message>
        <source>Reference: built in</source>
        <translation>Nachschlagen: eingebaut</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>Measurements</name>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>Entlang y</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Entlang z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>Halber Winkel</translation>
    </message>
    <message>
        <source>Distance of planes</source>
        <translation>Abstand der Ebenen</translation>
    </message>
    <message>
        <source>Distance of axes</source>
        <translation>Abstand der Achsen</translation>
    </message>
    <message>
        <source>Distance of centres</source>
        <translation>Abstand der Mittelpunkte</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mittelpunkt x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mittelpunkt y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Mittelpunkt z</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Major radius</source>
        <translation>Großer Radius</translation>
    </message>
    <message>
        <source>Minor radius</source>
        <translation>Kleiner Radius</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Size along x</source>
        <translation>Ausdehnung in x</translation>
    </message>
    <message>
        <source>Size along y</source>
        <translation>Ausdehnung in y</translation>
    </message>
    <message>
        <source>Size along z</source>
        <translation>Ausdehnung in z</translation>
    </message>
</context>
<context>
    <name>Registry</name>
    <message>
        <source>theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>length unit</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>navigation</source>
        <translation>Navigation</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>autosave</source>
        <translation>automatisch sichern</translation>
    </message>
    <message>
        <source>autosave minutes</source>
        <translation>Minuten bis zur Sicherung</translation>
    </message>
    <message>
        <source>threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>system</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>Perspektive</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>drawing tolerance</source>
        <translation>Zeichengenauigkeit</translation>
    </message>
    <message>
        <source>zebra stripes</source>
        <translation>Zebrastreifen</translation>
    </message>
    <message>
        <source>zebra angle</source>
        <translation>Winkel der Zebrastreifen</translation>
    </message>
    <message>
        <source>iso curves</source>
        <translation>Iso-Kurven</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::InfluenceChart</name>
    <message>
        <source>Influence of each control shape over t</source>
        <translation>Einfluss jeder Kontrollform über t</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::MorphCard</name>
    <message>
        <source>Ladder</source>
        <translation>Leiter</translation>
    </message>
    <message>
        <source>Draw the shapes between the control shapes and this one (L)</source>
        <translation>Die Formen zwischen den Kontrollformen und dieser zeichnen (L)</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morph</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>Einfluss</translation>
    </message>
    <message>
        <source>Draw how much each control shape counts over t</source>
        <translation>Zeichnen, wie viel jede Kontrollform über t zählt</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Draw the way of the sequence through the blossom</source>
        <translation>Den Weg der Sequenz durch die Blossom zeichnen</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::MorphTool</name>
    <message>
        <source>Move %1 in the morph</source>
        <translation>%1 im Morph verschieben</translation>
    </message>
    <message>
        <source>Drag to move %1 in the morph</source>
        <translation>Ziehen verschiebt %1 im Morph</translation>
    </message>
    <message>
        <source>Drag to move %1 in the morph · double click puts it back</source>
        <translation>Ziehen verschiebt %1 im Morph · Doppelklick setzt es zurück</translation>
    </message>
    <message>
        <source>Scale %1 in the morph</source>
        <translation>%1 im Morph skalieren</translation>
    </message>
    <message>
        <source>Turn %1 in the morph</source>
        <translation>%1 im Morph drehen</translation>
    </message>
    <message>
        <source>Put %1 back as it was drawn</source>
        <translation>%1 so zurücksetzen, wie es gezeichnet ist</translation>
    </message>
    <message>
        <source>t %1 · area %2</source>
        <translation>t %1 · Fläche %2</translation>
    </message>
    <message>
        <source>A morph with a degree or knots has no ladder.</source>
        <translation>Ein Morph mit Grad oder Knoten hat keine Leiter.</translation>
    </message>
    <message>
        <source>Three control shapes or more have a ladder.</source>
        <translation>Eine Leiter haben drei Kontrollformen oder mehr.</translation>
    </message>
    <message>
        <source>Some of the ladder takes too long to be drawn.</source>
        <translation>Ein Teil der Leiter dauert zu lange, um gezeichnet zu werden.</translation>
    </message>
    <message>
        <source>Type how many times as large · Enter takes it · Esc leaves it to the mouse</source>
        <translation>Tippen, wievielmal so groß · Enter übernimmt · Esc überlässt es der Maus</translation>
    </message>
    <message>
        <source>%1 is %2 times as large as drawn · type a number · Ctrl: no steps · Esc takes it back</source>
        <translation>%1 ist %2-mal so groß wie gezeichnet · Zahl tippen · Strg: ohne Stufen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Type the angle · Enter takes it · Esc leaves it to the mouse</source>
        <translation>Winkel tippen · Enter übernimmt · Esc überlässt es der Maus</translation>
    </message>
    <message>
        <source>%1 is turned by %2° · type a number · Ctrl: no steps · Esc takes it back</source>
        <translation>%1 ist um %2° gedreht · Zahl tippen · Strg: ohne Stufen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Type x, y · Enter takes it · Esc leaves it to the mouse</source>
        <translation>x, y tippen · Enter übernimmt · Esc überlässt es der Maus</translation>
    </message>
    <message>
        <source>%1 is moved by %2 · type x, y · Ctrl: no snapping · Esc takes it back</source>
        <translation>%1 ist um %2 verschoben · x, y tippen · Strg: ohne Fangen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag to scale %1 in the morph</source>
        <translation>Ziehen, um %1 im Morph zu skalieren</translation>
    </message>
    <message>
        <source>Drag to scale %1 in the morph · double click: as large as drawn</source>
        <translation>Ziehen, um %1 im Morph zu skalieren · Doppelklick: so groß wie gezeichnet</translation>
    </message>
    <message>
        <source>Drag to turn %1 in the morph</source>
        <translation>Ziehen, um %1 im Morph zu drehen</translation>
    </message>
    <message>
        <source>Drag to turn %1 in the morph · double click: as it was drawn</source>
        <translation>Ziehen, um %1 im Morph zu drehen · Doppelklick: wie gezeichnet</translation>
    </message>
    <message>
        <source>Drag the number of a control shape to move it, the square or the dot on its ring to scale or turn it · L: ladder</source>
        <translation>Die Nummer einer Kontrollform ziehen verschiebt sie, Quadrat und Punkt auf ihrem Ring skalieren und drehen sie · L: Leiter</translation>
    </message>
    <message>
        <source>A morph with a degree or knots has no path.</source>
        <translation>Ein Morph mit Grad oder Knoten hat keinen Weg.</translation>
    </message>
    <message>
        <source>Level %1, leg %2: t %3 · area %4</source>
        <translation>Stufe %1, Schenkel %2: t %3 · Fläche %4</translation>
    </message>
    <message>
        <source>Draw the path of the morph</source>
        <translation>Weg des Morphs zeichnen</translation>
    </message>
    <message>
        <source>Click to show the whole ladder again</source>
        <translation>Klicken zeigt wieder die ganze Leiter</translation>
    </message>
    <message>
        <source>Click to show the shape on this leg of the ladder</source>
        <translation>Klicken zeigt die Form auf diesem Schenkel der Leiter</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::PathPad</name>
    <message>
        <source>Path through the blossom</source>
        <translation>Weg durch die Blossom</translation>
    </message>
    <message>
        <source>Drag a point; double-click to put one in, Delete or a right click to take one out</source>
        <translation>Punkt ziehen; Doppelklick fügt einen ein, Entf oder Rechtsklick nimmt einen heraus</translation>
    </message>
</context>
<context>
    <name>blossom::modeling</name>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>on the curve</source>
        <translation>auf der Kurve</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>waagrecht</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>45°</source>
        <translation>45°</translation>
    </message>
    <message>
        <source>aligned with the start</source>
        <translation>auf Höhe des Anfangs</translation>
    </message>
    <message>
        <source>straight on</source>
        <translation>geradeaus</translation>
    </message>
    <message>
        <source>at right angles</source>
        <translation>im rechten Winkel</translation>
    </message>
    <message>
        <source>crossing of help lines</source>
        <translation>Schnitt der Hilfslinien</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>Lot</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DragTool</name>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Drag a handle to change the shape</source>
        <translation>Griff ziehen, um die Form zu ändern</translation>
    </message>
    <message>
        <source>Let go to place %1 · Ctrl: no snapping · Esc takes it back</source>
        <translation>Loslassen setzt %1 · Strg: kein Fang · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag to move %1</source>
        <translation>Ziehen verschiebt %1</translation>
    </message>
    <message>
        <source>The outline cannot have this size.</source>
        <translation>Der Umriss kann diese Größe nicht haben.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Type the size · Enter takes it · Esc leaves it as it is</source>
        <translation>Größe eingeben · Enter übernimmt · Esc lässt sie, wie sie ist</translation>
    </message>
    <message>
        <source>Double-click to type %1</source>
        <translation>Doppelklick, um %1 einzugeben</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DrawTool</name>
    <message>
        <source>The outline would meet itself at (%1, %2); move a point or take some back with Backspace.</source>
        <translation>Der Umriss würde sich bei (%1, %2) selbst treffen; einen Punkt verschieben oder mit Rücktaste einige zurücknehmen.</translation>
    </message>
    <message>
        <source>This point makes no segment; choose another.</source>
        <translation>Dieser Punkt ergibt kein Stück; einen anderen wählen.</translation>
    </message>
    <message>
        <source>Draw outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
    <message>
        <source>Click the first point, or type @ and its x,y</source>
        <translation>Den ersten Punkt anklicken, oder @ und sein x,y eingeben</translation>
    </message>
    <message>
        <source>Click a point that the arc passes, or type its radius</source>
        <translation>Einen Punkt anklicken, durch den der Bogen geht, oder den Radius eingeben</translation>
    </message>
    <message>
        <source>Line: click its end, or type a length and, after &lt;, an angle</source>
        <translation>Strecke: Ende anklicken, oder eine Länge und nach &lt; einen Winkel eingeben</translation>
    </message>
    <message>
        <source>Tangent arc: click its end; A for three points</source>
        <translation>Tangentialer Bogen: Ende anklicken; A für drei Punkte</translation>
    </message>
    <message>
        <source>Arc: click its end</source>
        <translation>Bogen: Ende anklicken</translation>
    </message>
    <message>
        <source>Spline: click the next point</source>
        <translation>Spline: nächsten Punkt anklicken</translation>
    </message>
    <message>
        <source>Enter places the point, Tab changes between length and angle, Esc leaves the entry</source>
        <translation>Enter setzt den Punkt, Tab wechselt zwischen Länge und Winkel, Esc verlässt die Eingabe</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Klicken schließt den Umriss</translation>
    </message>
    <message>
        <source>L line, A arc, S spline</source>
        <translation>L Strecke, A Bogen, S Spline</translation>
    </message>
    <message>
        <source>Backspace takes back</source>
        <translation>Rücktaste nimmt zurück</translation>
    </message>
    <message>
        <source>Enter finishes</source>
        <translation>Enter beendet</translation>
    </message>
    <message>
        <source>Ctrl: no snapping</source>
        <translation>Strg: kein Fang</translation>
    </message>
    <message>
        <source>Esc leaves</source>
        <translation>Esc verlässt</translation>
    </message>
    <message>
        <source>what is typed</source>
        <translation>was getippt ist</translation>
    </message>
    <message>
        <source>the last point</source>
        <translation>der letzte Punkt</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::EditTool</name>
    <message>
        <source>the first point</source>
        <translation>der erste Punkt</translation>
    </message>
    <message>
        <source>a point of the outline</source>
        <translation>ein Punkt des Umrisses</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>Punkt einfügen</translation>
    </message>
    <message>
        <source>Remove a point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Too little would be left of the outline; delete the feature itself instead.</source>
        <translation>Vom Umriss bliebe zu wenig übrig; stattdessen das Element selbst löschen.</translation>
    </message>
    <message>
        <source>Double-click to insert a point here</source>
        <translation>Doppelklick fügt hier einen Punkt ein</translation>
    </message>
    <message>
        <source>Drag points · double-click a segment to insert one · Delete removes the chosen one · Enter or Esc leaves</source>
        <translation>Punkte ziehen · Doppelklick auf ein Stück fügt einen ein · Entf entfernt den gewählten · Enter oder Esc verlässt</translation>
    </message>
    <message>
        <source>the length of this side</source>
        <translation>die Länge dieser Seite</translation>
    </message>
    <message>
        <source>This side is slanted, and only level and upright sides keep an expression with names: type its value, or write expressions for its points under &quot;segments&quot;.</source>
        <translation>Diese Seite ist schräg, und nur waagerechte und senkrechte Seiten behalten einen Ausdruck mit Namen: ihren Wert eingeben, oder für ihre Punkte unter „Segments“ Ausdrücke schreiben.</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::ShapeTool</name>
    <message>
        <source>the shape</source>
        <translation>die Form</translation>
    </message>
    <message>
        <source>the corner</source>
        <translation>die Ecke</translation>
    </message>
    <message>
        <source>the rounding</source>
        <translation>die Rundung</translation>
    </message>
    <message>
        <source>the size</source>
        <translation>die Größe</translation>
    </message>
    <message>
        <source>the width</source>
        <translation>die Breite</translation>
    </message>
    <message>
        <source>the height</source>
        <translation>die Höhe</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>die Länge</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>der Radius</translation>
    </message>
    <message>
        <source>the outer radius</source>
        <translation>der äußere Radius</translation>
    </message>
    <message>
        <source>the inner radius</source>
        <translation>der innere Radius</translation>
    </message>
    <message>
        <source>the first half-axis</source>
        <translation>die erste Halbachse</translation>
    </message>
    <message>
        <source>the second half-axis</source>
        <translation>die zweite Halbachse</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::MoveTool</name>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Moved by %1 · Ctrl: no steps · Esc takes it back</source>
        <translation>Verschoben um %1 · Strg: ohne Stufen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag an arrow to move the shape along an axis, the point to move it above the ground</source>
        <translation>Ein Pfeil verschiebt die Form entlang einer Achse, der Punkt über dem Boden</translation>
    </message>
    <message>
        <source>Drag: move it parallel to the ground</source>
        <translation>Ziehen: parallel zum Boden verschieben</translation>
    </message>
    <message>
        <source>Drag: move it along the arrow</source>
        <translation>Ziehen: entlang des Pfeils verschieben</translation>
    </message>
</context>
<context>
    <name>blossom::morphology::RadiusTool</name>
    <message>
        <source>Drag the radius</source>
        <translation>Radius ziehen</translation>
    </message>
    <message>
        <source>The radius is %1 · Ctrl: no steps · Esc takes it back</source>
        <translation>Der Radius ist %1 · Strg: ohne Stufen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag up or down to change the radius of %1</source>
        <translation>Nach oben oder unten ziehen ändert den Radius von %1</translation>
    </message>
    <message>
        <source>Drag the handle to change the radius</source>
        <translation>Am Griff ziehen ändert den Radius</translation>
    </message>
</context>
<context>
    <name>blossom::morphology::SumOverlay</name>
    <message>
        <source>corner + face</source>
        <translation>Ecke + Fläche</translation>
    </message>
    <message>
        <source>face + corner</source>
        <translation>Fläche + Ecke</translation>
    </message>
    <message>
        <source>edge + edge</source>
        <translation>Kante + Kante</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::CurveTool</name>
    <message>
        <source>Pull a point</source>
        <translation>Einen Punkt ziehen</translation>
    </message>
    <message>
        <source>Let go to pull the curve here · Esc takes it back</source>
        <translation>Loslassen zieht die Kurve hierher · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag to pull this point of the curve</source>
        <translation>Ziehen Sie, um diesen Punkt der Kurve zu ziehen</translation>
    </message>
    <message>
        <source>Drag a place near a control point to pull the smooth curve there</source>
        <translation>Ziehen Sie eine Stelle bei einem Kontrollpunkt, um die glatte Kurve dorthin zu ziehen</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::PullTool</name>
    <message>
        <source>Pull a point</source>
        <translation>Einen Punkt ziehen</translation>
    </message>
    <message>
        <source>Let go to pull the point here · Shift: along the normal · Esc takes it back</source>
        <translation>Loslassen zieht den Punkt hierher · Umschalt: entlang der Normalen · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag to pull this point of the surface</source>
        <translation>Ziehen, um diesen Punkt der Fläche zu ziehen</translation>
    </message>
    <message>
        <source>Drag a place over a vertex of the cage to pull the smooth surface there</source>
        <translation>Die glatte Fläche an der Stelle über einem Eckpunkt des Käfigs ziehen</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::StrokeTool</name>
    <message>
        <source>Pull to a stroke</source>
        <translation>Zu einem Strich ziehen</translation>
    </message>
    <message>
        <source>Draw a stroke</source>
        <translation>Einen Strich zeichnen</translation>
    </message>
    <message>
        <source>Click or draw where the shape is to run</source>
        <translation>Klicken oder zeichnen, wo die Form verlaufen soll</translation>
    </message>
    <message>
        <source>Click or draw the stroke</source>
        <translation>Den Strich klicken oder zeichnen</translation>
    </message>
    <message>
        <source>Click the next point, or drag to draw</source>
        <translation>Den nächsten Punkt klicken oder ziehend zeichnen</translation>
    </message>
    <message>
        <source>X, Y, Z: the plane across that axis</source>
        <translation>X, Y, Z: die Ebene quer zu dieser Achse</translation>
    </message>
    <message>
        <source>Backspace takes back</source>
        <translation>Rücktaste nimmt zurück</translation>
    </message>
    <message>
        <source>Enter pulls the shape to it</source>
        <translation>Eingabe zieht die Form dorthin</translation>
    </message>
    <message>
        <source>Enter finishes</source>
        <translation>Eingabe beendet</translation>
    </message>
    <message>
        <source>Esc leaves</source>
        <translation>Esc verlässt</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorNet</name>
    <message>
        <source>Poles over the (u, v) domain</source>
        <translation>Pole über dem Bereich von (u, v)</translation>
    </message>
    <message>
        <source>Click to insert a knot at %1 = %2</source>
        <translation>Klick fügt bei %1 = %2 einen Knoten ein</translation>
    </message>
    <message>
        <source>Click a pole to choose it, drag a frame around several · click in the margin to insert a knot</source>
        <translation>Einen Pol anklicken, um ihn zu wählen; einen Rahmen um mehrere ziehen · Klick in den Rand fügt einen Knoten ein</translation>
    </message>
    <message>
        <source>Drag to the right or left to turn the pole about the axis · Ctrl: choose several</source>
        <translation>Nach rechts oder links ziehen dreht den Pol um die Achse · Strg: mehrere wählen</translation>
    </message>
    <message>
        <source>Drag up or down to scale the pole · Ctrl: choose several</source>
        <translation>Nach oben oder unten ziehen skaliert den Pol · Strg: mehrere wählen</translation>
    </message>
    <message>
        <source>Drag up or down to change the weight of the pole · Ctrl: choose several</source>
        <translation>Nach oben oder unten ziehen ändert das Gewicht des Pols · Strg: mehrere wählen</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorsPanel</name>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Begleitsysteme</translation>
    </message>
    <message>
        <source>Draw the frames M(u, v) along u and v</source>
        <translation>Die Bezugssysteme M(u, v) entlang u und v zeichnen</translation>
    </message>
    <message>
        <source>Iso-curves</source>
        <translation>Iso-Kurven</translation>
    </message>
    <message>
        <source>Draw the curves of constant u and v at the knots</source>
        <translation>Die Kurven mit festem u und v an den Knoten zeichnen</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Kamm</translation>
    </message>
    <message>
        <source>Draw the curvature comb of the trajectory</source>
        <translation>Den Krümmungskamm der Bahn zeichnen</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Edit the poles of this factor</source>
        <translation>Die Pole dieses Faktors bearbeiten</translation>
    </message>
    <message>
        <source>Turn the chosen poles about the axis by the angle</source>
        <translation>Die gewählten Pole um die Achse drehen, um den Winkel</translation>
    </message>
    <message>
        <source>Give the chosen poles this turn from the fixed axes</source>
        <translation>Den gewählten Polen diese Drehung geben, von den festen Achsen aus</translation>
    </message>
    <message>
        <source>Along u</source>
        <translation>Längs u</translation>
    </message>
    <message>
        <source>The comb along u through the chosen pole</source>
        <translation>Der Kamm längs u durch den gewählten Pol</translation>
    </message>
    <message>
        <source>Along v</source>
        <translation>Längs v</translation>
    </message>
    <message>
        <source>The comb along v through the chosen pole</source>
        <translation>Der Kamm längs v durch den gewählten Pol</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>A drag in the net scales along this axis</source>
        <translation>Ziehen im Netz skaliert entlang dieser Achse</translation>
    </message>
    <message>
        <source>Close the card</source>
        <translation>Die Karte schließen</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorsTool</name>
    <message>
        <source>Move poles of the trajectory</source>
        <translation>Pole der Bahn verschieben</translation>
    </message>
    <message>
        <source>Insert a knot</source>
        <translation>Knoten einfügen</translation>
    </message>
    <message>
        <source>No pole is chosen</source>
        <translation>Kein Pol ist gewählt</translation>
    </message>
    <message>
        <source>%1 poles</source>
        <translation>%1 Pole</translation>
    </message>
    <message>
        <source>Pole %1 · reaches %2</source>
        <translation>Pol %1 · wirkt auf %2</translation>
    </message>
    <message>
        <source>Pole (%1, %2) · reaches %3, %4</source>
        <translation>Pol (%1, %2) · wirkt auf %3, %4</translation>
    </message>
    <message>
        <source>along u at v = %1</source>
        <translation>längs u bei v = %1</translation>
    </message>
    <message>
        <source>along v at u = %1</source>
        <translation>längs v bei u = %1</translation>
    </message>
    <message>
        <source>Curvature along v, 1/mm</source>
        <translation>Krümmung längs v, 1/mm</translation>
    </message>
    <message>
        <source>Angular velocity, ° per range, %1</source>
        <translation>Drehrate, ° je Bereich, %1</translation>
    </message>
    <message>
        <source>Factors with curvature, %1</source>
        <translation>Faktoren mit Krümmung, %1</translation>
    </message>
    <message>
        <source>Let go to turn by %1° · Esc takes it back</source>
        <translation>Loslassen dreht um %1° · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Let go to multiply the weight by %1 · Esc takes it back</source>
        <translation>Loslassen multipliziert das Gewicht mit %1 · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Let go to scale by %1 · Esc takes it back</source>
        <translation>Loslassen skaliert mit %1 · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Turn poles of the orientation</source>
        <translation>Pole der Orientierung drehen</translation>
    </message>
    <message>
        <source>Scale poles</source>
        <translation>Pole skalieren</translation>
    </message>
    <message>
        <source>Change weights of the trajectory</source>
        <translation>Gewichte der Bahn ändern</translation>
    </message>
    <message>
        <source>The motion is being prepared</source>
        <translation>Die Bewegung wird vorbereitet</translation>
    </message>
    <message>
        <source>Nothing will be changed here: %1</source>
        <translation>Hier wird nichts geändert: %1</translation>
    </message>
    <message>
        <source>Let go to move the pole here · Esc takes it back</source>
        <translation>Loslassen verschiebt den Pol hierher · Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag to move the pole along %1</source>
        <translation>Ziehen verschiebt den Pol entlang %1</translation>
    </message>
    <message>
        <source>Drag to move the pole in the plane of the view · Shift: choose several · Alt: turn the view</source>
        <translation>Ziehen verschiebt den Pol in der Ebene der Ansicht · Umschalt: mehrere wählen · Alt: Ansicht drehen</translation>
    </message>
    <message>
        <source>Drag a pole of the trajectory, or choose one to move it along an axis</source>
        <translation>Einen Pol der Bahn ziehen, oder einen wählen, um ihn entlang einer Achse zu verschieben</translation>
    </message>
    <message>
        <source>Choose poles in the net and drag them there</source>
        <translation>Pole im Netz wählen und dort ziehen</translation>
    </message>
    <message>
        <source>%1, the first pole</source>
        <translation>%1, erster Pol</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::GoalEntry</name>
    <message>
        <source>A target has three coordinates: x, y, z. One that is left empty stays, as in &quot;0, -20,&quot;.</source>
        <translation>Ein Ziel hat drei Koordinaten: x, y, z. Eine leere bleibt, wie in „0, -20,“.</translation>
    </message>
    <message>
        <source>%1 coordinates were typed; a target has three: x, y, z.</source>
        <translation>%1 Koordinaten wurden getippt; ein Ziel hat drei: x, y, z.</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::PullMode</name>
    <message>
        <source>by turning and scaling</source>
        <translation>durch Drehen und Skalieren</translation>
    </message>
    <message>
        <source>by moving the sections</source>
        <translation>durch Verschieben der Schnitte</translation>
    </message>
    <message>
        <source>by turning alone</source>
        <translation>nur durch Drehen</translation>
    </message>
    <message>
        <source>by scaling alone</source>
        <translation>nur durch Skalieren</translation>
    </message>
    <message>
        <source>by twisting</source>
        <translation>durch Verdrehen</translation>
    </message>
    <message>
        <source>the tangent of the trajectory</source>
        <translation>die Tangente der Bahn</translation>
    </message>
    <message>
        <source>the arm from the trajectory to the point</source>
        <translation>den Arm von der Bahn zum Punkt</translation>
    </message>
    <message>
        <source>the axis across tangent and arm</source>
        <translation>die Achse quer zu Tangente und Arm</translation>
    </message>
    <message>
        <source>%1 copies, mirrored</source>
        <translation>%1 Kopien, gespiegelt</translation>
    </message>
    <message>
        <source>%1 copies</source>
        <translation>%1 Kopien</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>one level finer</source>
        <translation>eine Stufe feiner</translation>
    </message>
    <message>
        <source>one level coarser</source>
        <translation>eine Stufe gröber</translation>
    </message>
    <message>
        <source>%1 levels finer</source>
        <translation>%1 Stufen feiner</translation>
    </message>
    <message>
        <source>%1 levels coarser</source>
        <translation>%1 Stufen gröber</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>durch %1</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>Skalieren</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::SurfacePullTool</name>
    <message>
        <source>Twist the surface</source>
        <translation>Fläche verdrehen</translation>
    </message>
    <message>
        <source>Pull the surface</source>
        <translation>Fläche ziehen</translation>
    </message>
    <message>
        <source>Drag a place on the surface to pull it</source>
        <translation>Eine Stelle der Fläche ziehen, um sie zu verformen</translation>
    </message>
    <message>
        <source>Drag a place on the surface to twist it</source>
        <translation>Eine Stelle der Fläche ziehen, um sie zu verdrehen</translation>
    </message>
    <message>
        <source>Nothing will be changed here: %1</source>
        <translation>Hier wird nichts geändert: %1</translation>
    </message>
    <message>
        <source>Let go to twist by %1° about %2</source>
        <translation>Loslassen verdreht um %1° um %2</translation>
    </message>
    <message>
        <source>A: another axis</source>
        <translation>A: andere Achse</translation>
    </message>
    <message>
        <source>Let go to pull the point here %1</source>
        <translation>Loslassen zieht den Punkt hierher, %1</translation>
    </message>
    <message>
        <source>Shift: along the normal</source>
        <translation>Umschalt: entlang der Normalen</translation>
    </message>
    <message>
        <source>Esc takes it back</source>
        <translation>Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>1: no copies</source>
        <translation>1: keine Kopien</translation>
    </message>
    <message>
        <source>Drag to twist the surface here about %1</source>
        <translation>Ziehen verdreht die Fläche hier um %1</translation>
    </message>
    <message>
        <source>W: pull</source>
        <translation>W: ziehen</translation>
    </message>
    <message>
        <source>Drag to change the selected edit here; those after it are hidden meanwhile</source>
        <translation>Ziehen ändert hier die gewählte Bearbeitung; die nach ihr sind solange verborgen</translation>
    </message>
    <message>
        <source>Enter: type its goal</source>
        <translation>Enter: sein Ziel eingeben</translation>
    </message>
    <message>
        <source>The surface of the selected edit is being prepared</source>
        <translation>Die Fläche der gewählten Bearbeitung wird vorbereitet</translation>
    </message>
    <message>
        <source>Let go to twist by %1° in the selected edit</source>
        <translation>Loslassen verdreht um %1° in der gewählten Bearbeitung</translation>
    </message>
    <message>
        <source>Let go to pull the point here in the selected edit</source>
        <translation>Loslassen zieht den Punkt in der gewählten Bearbeitung hierher</translation>
    </message>
    <message>
        <source>Drag to pull further, %1</source>
        <translation>Ziehen: weiter %1</translation>
    </message>
    <message>
        <source>Drag to pull %1</source>
        <translation>Ziehen: Punkt bewegen %1</translation>
    </message>
    <message>
        <source>W: twist</source>
        <translation>W: verdrehen</translation>
    </message>
    <message>
        <source>2–9, M: copies</source>
        <translation>2–9, M: Kopien</translation>
    </message>
    <message>
        <source>%1 (1: none)</source>
        <translation>%1 (1: keine)</translation>
    </message>
    <message>
        <source>Type the angle of the twist · Enter takes it · Esc leaves it as it is</source>
        <translation>Winkel der Verdrehung eingeben · Enter übernimmt · Esc lässt ihn, wie er ist</translation>
    </message>
    <message>
        <source>Type where the point goes: x, y, z · Enter takes it · Esc leaves it as it is</source>
        <translation>Eingeben, wohin der Punkt kommt: x, y, z · Enter übernimmt · Esc lässt es, wie es ist</translation>
    </message>
    <message>
        <source>Poles move %1 times as far: places and pins are too near each other</source>
        <translation>Pole bewegen sich %1-mal so weit: Stellen und festgesteckte sind einander zu nahe</translation>
    </message>
    <message>
        <source>The places cannot all arrive; %1 is left at most</source>
        <translation>Nicht alle Stellen können ankommen; es fehlen höchstens %1</translation>
    </message>
    <message>
        <source>Enter: type the angle</source>
        <translation>Enter: Winkel eingeben</translation>
    </message>
    <message>
        <source>Enter: type the target</source>
        <translation>Enter: Ziel eingeben</translation>
    </message>
    <message>
        <source>Shift-click: take along</source>
        <translation>Umschalt+Klick: mitnehmen</translation>
    </message>
    <message>
        <source>P: pin it</source>
        <translation>P: feststecken</translation>
    </message>
    <message>
        <source>chosen: %1, pinned: %2 (Esc: none)</source>
        <translation>gewählt: %1, festgesteckt: %2 (Esc: keine)</translation>
    </message>
    <message>
        <source>+, −: finer, coarser</source>
        <translation>+, −: feiner, gröber</translation>
    </message>
    <message>
        <source>%1 (0: as it is)</source>
        <translation>%1 (0: unverändert)</translation>
    </message>
    <message>
        <source>No sweep is made of this motion: choose Sweep to see its surface and pull it</source>
        <translation>Aus dieser Bewegung ist kein Sweep gemacht: Sweep wählen, um ihre Fläche zu sehen und zu ziehen</translation>
    </message>
    <message>
        <source>Let go to pull %1 places %2</source>
        <translation>Loslassen zieht %1 Stellen, %2</translation>
    </message>
    <message>
        <source>Let go to twist %1 places by %2° about %3</source>
        <translation>Loslassen verdreht %1 Stellen um %2° um %3</translation>
    </message>
    <message>
        <source>%1 pinned</source>
        <translation>%1 festgesteckt</translation>
    </message>
    <message>
        <source>wheel: share of %1</source>
        <translation>Mausrad: Anteil von %1</translation>
    </message>
    <message>
        <source>Shift+wheel: share of %1</source>
        <translation>Umschalt+Mausrad: Anteil von %1</translation>
    </message>
    <message>
        <source>T, R, S: one alone (Shift: as well)</source>
        <translation>T, R, S: nur eine Art (Umschalt: zusätzlich)</translation>
    </message>
    <message>
        <source>Let go to twist about this axis</source>
        <translation>Loslassen verdreht um diese Achse</translation>
    </message>
    <message>
        <source>Shift: along x, y, z, the tangent, the arm or across both</source>
        <translation>Umschalt: längs x, y, z, der Tangente, des Arms oder quer zu beiden</translation>
    </message>
    <message>
        <source>Drag to turn the axis of this twist</source>
        <translation>Ziehen schwenkt die Achse dieser Verdrehung</translation>
    </message>
    <message>
        <source>Turn the axis of a twist</source>
        <translation>Achse einer Verdrehung schwenken</translation>
    </message>
    <message>
        <source>selected edit: %1</source>
        <translation>gewählte Bearbeitung: %1</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::TurnBall</name>
    <message>
        <source>Trackball</source>
        <translation>Drehkugel</translation>
    </message>
    <message>
        <source>Drag to turn the chosen poles as the view sees them; along the rim, about the line of sight</source>
        <translation>Ziehen dreht die gewählten Pole, wie die Ansicht sie sieht; am Rand entlang um die Blickrichtung</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::ValidityMarks</name>
    <message>
        <source>smallest normal</source>
        <translation>kleinste Normale</translation>
    </message>
    <message>
        <source>smallest weight</source>
        <translation>kleinstes Gewicht</translation>
    </message>
    <message>
        <source>crosses itself</source>
        <translation>durchdringt sich</translation>
    </message>
</context>
<context>
    <name>blossom::ui::AboutDialog</name>
    <message>
        <source>The text of the licence is not installed. It can be read at https://www.gnu.org/licenses/gpl-3.0.txt.</source>
        <translation>Der Text der Lizenz ist nicht installiert. Er steht unter https://www.gnu.org/licenses/gpl-3.0.txt.</translation>
    </message>
    <message>
        <source>About Blossom</source>
        <translation>Über Blossom</translation>
    </message>
    <message>
        <source>&amp;Copy versions</source>
        <translation>Versionen &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Licence</source>
        <translation>&amp;Lizenz</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Blossom %1</source>
        <translation>Blossom %1</translation>
    </message>
    <message>
        <source>A workbench for shapes that morph, sweep, grow and melt.
Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Eine Werkbank für Formen, die sich wandeln, streichen, wachsen und schmelzen.
Freie Software unter der GNU General Public License, Version 3 oder neuer.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Chip</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ChoiceField</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>muss angegeben werden</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ChooseTool</name>
    <message>
        <source>Esc ends</source>
        <translation>Esc beendet</translation>
    </message>
    <message>
        <source>%1: click it in the view or in the document; Esc ends</source>
        <translation>%1: in der Ansicht oder im Dokument anklicken; Esc beendet</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ColorField</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>muss angegeben werden</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature, a page of the manual</source>
        <translation>Befehl, Beispiel, Element oder Seite des Handbuchs suchen</translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;.</source>
        <translation>Nichts heißt „%1“.</translation>
    </message>
    <message>
        <source>Return or click: %1 · Up and down: choose · Esc: close</source>
        <translation>Enter oder Klick: %1 · Auf und ab: wählen · Esc: schließen</translation>
    </message>
    <message>
        <source>%1 cannot be done now. %2</source>
        <translation>%1 ist jetzt nicht möglich. %2</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurvatureLegend</name>
    <message>
        <source>Gaussian curvature</source>
        <translation>Gaußsche Krümmung</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Größte Krümmung</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveEditor</name>
    <message>
        <source>Click to add a point, drag to move it, right click or Delete to remove it</source>
        <translation>Klicken fügt einen Punkt hinzu, Ziehen verschiebt ihn, Rechtsklick oder Entf entfernt ihn</translation>
    </message>
    <message>
        <source>click to add a point</source>
        <translation>klicken fügt einen Punkt hinzu</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveField</name>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>t of the chosen point</source>
        <translation>t des gewählten Punkts</translation>
    </message>
    <message>
        <source>value of the chosen point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> Der Wert davor bleibt.</translation>
    </message>
    <message>
        <source>Remove all points</source>
        <translation>Alle Punkte entfernen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentClosing</name>
    <message>
        <source>%1 (sample, untitled)</source>
        <translation>%1 (Beispiel, unbenannt)</translation>
    </message>
    <message>
        <source>%1 (untitled)</source>
        <translation>%1 (unbenannt)</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>%1, tab %2</source>
        <translation>%1, Reiter %2</translation>
    </message>
    <message>
        <source>%1 is still being written; it is closed then.</source>
        <translation>%1 wird noch geschrieben; danach wird es geschlossen.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentCommands</name>
    <message>
        <source>Recomp&amp;ute</source>
        <translation>Alles neu &amp;berechnen</translation>
    </message>
    <message>
        <source>Compute every feature anew, also those whose results are known.</source>
        <translation>Jedes Feature neu berechnen, auch solche, deren Ergebnisse bekannt sind.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation>Die letzte Änderung zurücknehmen.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do again what was taken back.</source>
        <translation>Wieder tun, was zurückgenommen wurde.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Take the selected features out, to be pasted elsewhere.</source>
        <translation>Die gewählten Elemente herausnehmen, um sie anderswo einzufügen.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Keep the selected features, and what they are made from, to be pasted.</source>
        <translation>Die gewählten Elemente und woraus sie entstehen zum Einfügen merken.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Add the features that were copied, in this document or another.</source>
        <translation>Die kopierten Elemente hinzufügen, in diesem oder einem anderen Dokument.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Verdoppeln</translation>
    </message>
    <message>
        <source>Add the selected features once more, made from the same inputs.</source>
        <translation>Die gewählten Elemente noch einmal hinzufügen, aus denselben Eingängen.</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Give the selected feature another name.</source>
        <translation>Dem gewählten Element einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Show or &amp;hide</source>
        <translation>Zeigen oder ver&amp;bergen</translation>
    </message>
    <message>
        <source>Show or hide the selected features.</source>
        <translation>Die gewählten Elemente zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Isolieren</translation>
    </message>
    <message>
        <source>Show only the selected features; once more: what was shown before.</source>
        <translation>Nur die gewählten Elemente zeigen; noch einmal: was vorher zu sehen war.</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Sho&amp;w everything</source>
        <translation>Alles &amp;zeigen</translation>
    </message>
    <message>
        <source>Show every feature.</source>
        <translation>Jedes Element zeigen.</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Suppress</source>
        <translation>&amp;Unterdrücken</translation>
    </message>
    <message>
        <source>Leave the selected features out of the computation, or take them in again.</source>
        <translation>Die gewählten Elemente aus der Berechnung nehmen, oder wieder hinein.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U</source>
        <translation>Ctrl+Shift+U</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Put the selected features one place further up; edits that follow one another change places.</source>
        <translation>Die gewählten Elemente einen Platz nach oben rücken; Änderungen, die aufeinander folgen, tauschen die Plätze.</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>Put the selected features one place further down; edits that follow one another change places.</source>
        <translation>Die gewählten Elemente einen Platz nach unten rücken; Änderungen, die aufeinander folgen, tauschen die Plätze.</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected features.</source>
        <translation>Die gewählten Elemente löschen.</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles wählen</translation>
    </message>
    <message>
        <source>Select every feature.</source>
        <translation>Jedes Element wählen.</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>Ni&amp;chts wählen</translation>
    </message>
    <message>
        <source>Select no feature.</source>
        <translation>Kein Element wählen.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Find in the document</source>
        <translation>Im Dokument &amp;suchen</translation>
    </message>
    <message>
        <source>Look for features by name, type or state.</source>
        <translation>Elemente nach Name, Art oder Zustand suchen.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Fit to &amp;selection</source>
        <translation>Aus&amp;wahl einpassen</translation>
    </message>
    <message>
        <source>Show just the selected features, as large as fits.</source>
        <translation>Nur die gewählten Elemente zeigen, so groß es geht.</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>Nothing has been changed yet.</source>
        <translation>Noch wurde nichts geändert.</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Nothing was taken back.</source>
        <translation>Nichts wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ver&amp;bergen</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Compute a&amp;gain</source>
        <translation>Wieder &amp;berechnen</translation>
    </message>
    <message>
        <source>End &amp;isolation</source>
        <translation>&amp;Isolieren beenden</translation>
    </message>
    <message>
        <source>Select a feature first.</source>
        <translation>Zuerst ein Element wählen.</translation>
    </message>
    <message>
        <source>Select one feature only.</source>
        <translation>Nur ein Element wählen.</translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation>Das Dokument ist leer.</translation>
    </message>
    <message>
        <source>&amp;Make from it</source>
        <translation>Daraus &amp;machen</translation>
    </message>
    <message>
        <source>Named &amp;numbers…</source>
        <translation>Benannte &amp;Zahlen…</translation>
    </message>
    <message>
        <source>Numbers with names that every field can use.</source>
        <translation>Zahlen mit Namen, die jedes Feld benutzen kann.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentExport</name>
    <message>
        <source>Replace %1?</source>
        <translation>%1 ersetzen?</translation>
    </message>
    <message>
        <source>Replace %1 files, %2 to %3?</source>
        <translation>%1 Dateien ersetzen, %2 bis %3?</translation>
    </message>
    <message>
        <source>Each frame of the sequence is a file of its own, and these are there already.</source>
        <translation>Jedes Bild der Folge ist eine eigene Datei, und diese gibt es schon.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The %1 selected results as one file</source>
        <translation>Die %1 gewählten Ergebnisse als eine Datei</translation>
    </message>
    <message>
        <source>All %1 visible results as one file</source>
        <translation>Alle %1 sichtbaren Ergebnisse als eine Datei</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>A sequence is exported alone.</source>
        <translation>Eine Folge wird allein exportiert.</translation>
    </message>
    <message>
        <source>Select the sequence or the shapes, not both.</source>
        <translation>Die Folge oder die Formen auswählen, nicht beides.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentFiles</name>
    <message>
        <source>Blossom documents (*.blossom)</source>
        <translation>Blossom-Dokumente (*.blossom)</translation>
    </message>
    <message>
        <source>%1 is not there.</source>
        <translation>%1 ist nicht da.</translation>
    </message>
    <message>
        <source>%1 has no extension that Blossom reads.</source>
        <translation>%1 hat keine Endung, die Blossom liest.</translation>
    </message>
    <message>
        <source>%1 of %2 files cannot be opened.</source>
        <translation>%1 von %2 Dateien können nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Since it was opened here, somebody else has written it. Saving replaces what they wrote.</source>
        <translation>Seit es hier geöffnet wurde, hat es jemand anders geschrieben. Speichern ersetzt das.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>Saving replaces it.</source>
        <translation>Speichern ersetzt es.</translation>
    </message>
    <message>
        <source>%1 is a folder. Open the files in it instead.</source>
        <translation>%1 ist ein Ordner. Öffnen Sie stattdessen die Dateien darin.</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Das kann nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentModel</name>
    <message>
        <source>suppressed</source>
        <translation>unterdrückt</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>wird berechnet…</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>nicht berechnet</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>Compute it in its properties.</source>
        <translation>In seinen Eigenschaften wird es berechnet.</translation>
    </message>
    <message>
        <source>a step warns · %1</source>
        <translation>ein Schritt warnt · %1</translation>
    </message>
    <message>
        <source>Unfold it to see which.</source>
        <translation>Aufklappen zeigt, welcher.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentPage</name>
    <message>
        <source>Computing</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>The file was written; look at this before you use it.</source>
        <translation>Die Datei ist geschrieben; lesen Sie dies, bevor Sie sie verwenden.</translation>
    </message>
    <message>
        <source>Not everything could be read.</source>
        <translation>Nicht alles war lesbar.</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Arbeitet</translation>
    </message>
    <message>
        <source>The handles of %1 cannot be shown.</source>
        <translation>Die Griffe von %1 können nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Open what is readable</source>
        <translation>Öffnen, was lesbar ist</translation>
    </message>
    <message>
        <source>This document names files outside its folder. They were not read.</source>
        <translation>Dieses Dokument nennt Dateien außerhalb seines Ordners. Sie wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>Read them</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Computing was cancelled.</source>
        <translation>Die Berechnung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>What was ready is shown.</source>
        <translation>Was fertig war, wird gezeigt.</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>%1 abspielen</translation>
    </message>
    <message>
        <source>Looking at the surfaces</source>
        <translation>Flächen untersuchen</translation>
    </message>
    <message>
        <source>Move a key of %1</source>
        <translation>Schlüssel von %1 verschieben</translation>
    </message>
    <message>
        <source>Set a key of %1</source>
        <translation>Schlüssel von %1 setzen</translation>
    </message>
    <message>
        <source>Remove a key of %1</source>
        <translation>Schlüssel von %1 entfernen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTabs</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close others</source>
        <translation>Andere schließen</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTree</name>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>error failed</source>
        <translation>Fehler gescheitert</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>Click: hide %1</source>
        <translation>Klick: %1 verbergen</translation>
    </message>
    <message>
        <source>Click: show %1</source>
        <translation>Klick: %1 zeigen</translation>
    </message>
    <message>
        <source>%1 · Click: select · Ctrl+click: select more · Double click: rename · Drag: reorder · Right click: more</source>
        <translation>%1 · Klick: wählen · Strg+Klick: mehr wählen · Doppelklick: umbenennen · Ziehen: umordnen · Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>Release: move here</source>
        <translation>Loslassen: hierher verschieben</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>Show %1 features</source>
        <translation>%1 Elemente zeigen</translation>
    </message>
    <message>
        <source>Hide %1 features</source>
        <translation>%1 Elemente verbergen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>End isolation</source>
        <translation>Isolieren beenden</translation>
    </message>
    <message>
        <source>Isolate %1</source>
        <translation>%1 isolieren</translation>
    </message>
    <message>
        <source>Isolate %1 features</source>
        <translation>%1 Elemente isolieren</translation>
    </message>
    <message>
        <source>Suppress %1</source>
        <translation>%1 unterdrücken</translation>
    </message>
    <message>
        <source>Suppress %1 features</source>
        <translation>%1 Elemente unterdrücken</translation>
    </message>
    <message>
        <source>Compute %1 again</source>
        <translation>%1 wieder berechnen</translation>
    </message>
    <message>
        <source>Compute %1 features again</source>
        <translation>%1 Elemente wieder berechnen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete %1 features</source>
        <translation>%1 Elemente löschen</translation>
    </message>
    <message>
        <source> and %1</source>
        <translation> und %1</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Das Gewählte</translation>
    </message>
    <message>
        <source>Delete that too, or suppress: what is suppressed stays but is not computed.</source>
        <translation>Auch das löschen, oder unterdrücken: Unterdrücktes bleibt, wird aber nicht berechnet.</translation>
    </message>
    <message>
        <source>Delete them too, or suppress: what is suppressed stays but is not computed.</source>
        <translation>Auch diese löschen, oder unterdrücken: Unterdrücktes bleibt, wird aber nicht berechnet.</translation>
    </message>
    <message>
        <source>%1 is used by %2.</source>
        <translation>%1 wird von %2 gebraucht.</translation>
    </message>
    <message>
        <source>Delete alone</source>
        <translation>Allein löschen</translation>
    </message>
    <message>
        <source>Delete all %1</source>
        <translation>Alle %1 löschen</translation>
    </message>
    <message>
        <source>Suppress</source>
        <translation>Unterdrücken</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Move %1 features</source>
        <translation>%1 Elemente verschieben</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Paste %1 features</source>
        <translation>%1 Elemente einfügen</translation>
    </message>
    <message>
        <source>There are no features on the clipboard.</source>
        <translation>In der Zwischenablage sind keine Elemente.</translation>
    </message>
    <message>
        <source>Select some and copy them first.</source>
        <translation>Zuerst einige wählen und kopieren.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>Duplicate %1 features</source>
        <translation>%1 Elemente verdoppeln</translation>
    </message>
    <message>
        <source>Click: show the steps of %1</source>
        <translation>Klick: Schritte von %1 zeigen</translation>
    </message>
    <message>
        <source>Click: fold the steps of %1</source>
        <translation>Klick: Schritte von %1 einklappen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTreePanel</name>
    <message>
        <source>Name, type or state</source>
        <translation>Name, Art oder Zustand</translation>
    </message>
    <message>
        <source>Find in the document</source>
        <translation>Im Dokument suchen</translation>
    </message>
    <message>
        <source>DOCUMENT</source>
        <translation>DOKUMENT</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ErrorBar</name>
    <message>
        <source>Dismiss (Esc)</source>
        <translation>Ausblenden (Esc)</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ExportDialog</name>
    <message>
        <source>Shapes of these kinds do not go into one file.</source>
        <translation>Formen dieser Arten passen nicht in eine Datei.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FaultBar</name>
    <message>
        <source>Show the feature</source>
        <translation>Zum Element</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureHeader</name>
    <message>
        <source>Name of the feature</source>
        <translation>Name des Elements</translation>
    </message>
    <message>
        <source>Name of the feature; type another one</source>
        <translation>Name des Elements; hier lässt er sich ändern</translation>
    </message>
    <message>
        <source>Read about it in the manual</source>
        <translation>Im Handbuch nachlesen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureMenus</name>
    <message>
        <source>Everything that can be read (%1)</source>
        <translation>Alles Lesbare (%1)</translation>
    </message>
    <message>
        <source>Takes %1.</source>
        <translation>Braucht: %1.</translation>
    </message>
    <message>
        <source>%1 takes %2 of the %3 selected shapes.</source>
        <translation>%1 nimmt %2 der %3 ausgewählten Formen.</translation>
    </message>
    <message>
        <source>Left out: %1.</source>
        <translation>Weggelassen: %1.</translation>
    </message>
    <message>
        <source>There is nothing here yet for %1: it takes %2.</source>
        <translation>Hier ist noch nichts für %1; gebraucht wird: %2.</translation>
    </message>
    <message>
        <source>There is too little here for %1, which takes %3 of these: %2.</source>
        <translation>Hier ist zu wenig für %1; gebraucht werden %3 hiervon: %2.</translation>
    </message>
    <message>
        <source>Draw or make one, or import a file.</source>
        <translation>Zeichnen oder erzeugen Sie es, oder importieren Sie eine Datei.</translation>
    </message>
    <message>
        <source>Import a file…</source>
        <translation>Datei importieren…</translation>
    </message>
    <message>
        <source>%1: choose a file with %2</source>
        <translation>%1: Datei wählen mit: %2</translation>
    </message>
    <message>
        <source>%1 takes nothing hidden: %2.</source>
        <translation>%1 nimmt nichts Verborgenes: %2.</translation>
    </message>
    <message>
        <source>Show them first, or select in the tree what it is to take.</source>
        <translation>Zuerst einblenden oder im Baum auswählen, was genommen werden soll.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureStart</name>
    <message>
        <source>a shape</source>
        <translation>eine Form</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Choose %1 for %2</source>
        <translation>Für %2 wählen: %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureToolBar</name>
    <message>
        <source>Everything of %1</source>
        <translation>Alles aus %1</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Weiteres</translation>
    </message>
    <message>
        <source>The groups for which the window is too narrow</source>
        <translation>Die Gruppen, für die das Fenster zu schmal ist</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FileCommands</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the workbench.</source>
        <translation>Die Werkbank schließen.</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation>Ein leeres Dokument beginnen.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>Open documents, or geometry in new ones.</source>
        <translation>Dokumente öffnen, oder Geometrie in neuen.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a s&amp;ample</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Show samples and recent documents.</source>
        <translation>Beispiele und letzte Dokumente zeigen.</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Add geometry from files to this document.</source>
        <translation>Geometrie aus Dateien zu diesem Dokument hinzufügen.</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Write the selected results, or all that is visible, as STEP, STL, a picture, …</source>
        <translation>Die gewählten Ergebnisse oder alles Sichtbare als STEP, STL, Bild, … schreiben.</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save this document.</source>
        <translation>Dieses Dokument speichern.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save this document under another name.</source>
        <translation>Dieses Dokument unter anderem Namen speichern.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Ne&amp;xt document</source>
        <translation>Näch&amp;stes Dokument</translation>
    </message>
    <message>
        <source>Show the document in the next tab.</source>
        <translation>Das Dokument im nächsten Reiter zeigen.</translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation>Ctrl+Tab</translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation>Ctrl+PgDown</translation>
    </message>
    <message>
        <source>&amp;Previous document</source>
        <translation>&amp;Voriges Dokument</translation>
    </message>
    <message>
        <source>Show the document in the tab before.</source>
        <translation>Das Dokument im Reiter davor zeigen.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Tab</source>
        <translation>Ctrl+Shift+Tab</translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation>Ctrl+PgUp</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close this document.</source>
        <translation>Dieses Dokument schließen.</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Close ot&amp;hers</source>
        <translation>An&amp;dere schließen</translation>
    </message>
    <message>
        <source>Close every document but this one.</source>
        <translation>Jedes Dokument außer diesem schließen.</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (nicht mehr da)</translation>
    </message>
    <message>
        <source>Takes it off this list</source>
        <translation>Nimmt es von der Liste</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation>Das Dokument ist leer.</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved.</source>
        <translation>Seit dem Speichern hat sich nichts geändert.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FileField</name>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of the type %2. The value before is kept.</source>
        <translation>„%1“ ist keine Datei der Art %2. Der Wert davor bleibt.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. The value before is kept.</source>
        <translation>Es gibt keine Datei „%1“. Der Wert davor bleibt.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FindField</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::GuardedApplication</name>
    <message>
        <source>Blossom met a fault of its own: %1.</source>
        <translation>Blossom ist auf einen eigenen Fehler gestoßen: %1.</translation>
    </message>
    <message>
        <source>What you did last may be undone. Save under another name and start Blossom anew.</source>
        <translation>Der letzte Schritt kann rückgängig gemacht werden. Unter anderem Namen speichern und Blossom neu starten.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::HelpMenu</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Read how everything works.</source>
        <translation>Lesen, wie alles geht.</translation>
    </message>
    <message>
        <source>About the &amp;selected feature</source>
        <translation>Über das &amp;gewählte Element</translation>
    </message>
    <message>
        <source>The manual&apos;s page of the selected feature: inputs, parameters, examples.</source>
        <translation>Die Seite des Handbuchs über das gewählte Element: Eingänge, Parameter, Beispiele.</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>How to move around, and every key.</source>
        <translation>Wie man sich bewegt, und jede Taste.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>A walk through the window in four steps.</source>
        <translation>Ein Rundgang durch das Fenster in vier Schritten.</translation>
    </message>
    <message>
        <source>&amp;About Blossom</source>
        <translation>&amp;Über Blossom</translation>
    </message>
    <message>
        <source>Versions and licence.</source>
        <translation>Versionen und Lizenz.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::InputEditor</name>
    <message>
        <source>Add an input</source>
        <translation>Eingang hinzufügen</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>In der Ansicht wählen</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>muss angegeben werden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Nothing else fits here</source>
        <translation>Nichts anderes passt hier</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs this feature itself; taking it would go round in a circle.</source>
        <translation>„%1“ braucht dieses Element selbst; so ginge es im Kreis.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, which does not fit here.</source>
        <translation>„%1“ passt hier nicht: %2.</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
    <message>
        <source>Click what %1 is to be; Esc ends</source>
        <translation>Anklicken, was %1 sein soll; Esc beendet</translation>
    </message>
    <message>
        <source>There is no room for more.</source>
        <translation>Für mehr ist kein Platz.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsDelegate</name>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsList</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Berechnen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsPanel</name>
    <message>
        <source>Jobs</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Click: cancel %1</source>
        <translation>Klick: %1 abbrechen</translation>
    </message>
    <message>
        <source>Cross: cancel · Right click: more</source>
        <translation>Kreuz: abbrechen · Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>Right click: copy the message, forget what has finished</source>
        <translation>Rechtsklick: Meldung kopieren, Fertiges vergessen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Copy the message</source>
        <translation>Meldung kopieren</translation>
    </message>
    <message>
        <source>Forget what has finished</source>
        <translation>Fertiges vergessen</translation>
    </message>
    <message>
        <source>Nothing is being computed, read or written.</source>
        <translation>Nichts wird berechnet, gelesen oder geschrieben.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::KeyMarks</name>
    <message>
        <source>Keys</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Drag a key to another frame; double-click to set one, Delete or a right click to remove one</source>
        <translation>Schlüssel zu einem anderen Bild ziehen; Doppelklick setzt einen, Entf oder Rechtsklick entfernt einen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::KeyRecorder</name>
    <message>
        <source>Press keys…</source>
        <translation>Tasten drücken…</translation>
    </message>
    <message>
        <source>No keys: click to set</source>
        <translation>Keine Tasten: klicken zum Setzen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListField</name>
    <message>
        <source>Add an item</source>
        <translation>Eintrag hinzufügen</translation>
    </message>
    <message>
        <source>Add an item to %1</source>
        <translation>Eintrag zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Add the missing items</source>
        <translation>Fehlende Einträge hinzufügen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListRow</name>
    <message>
        <source>Drag to another place</source>
        <translation>An eine andere Stelle ziehen</translation>
    </message>
    <message>
        <source>Move or copy this item</source>
        <translation>Diesen Eintrag verschieben oder kopieren</translation>
    </message>
    <message>
        <source>Remove this item</source>
        <translation>Diesen Eintrag entfernen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Copy below</source>
        <translation>Darunter kopieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogAndJobs</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Jobs</source>
        <translation>&amp;Aufgaben</translation>
    </message>
    <message>
        <source>Show what is being computed, read and written.</source>
        <translation>Zeigen, was berechnet, gelesen und geschrieben wird.</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>&amp;Protokoll</translation>
    </message>
    <message>
        <source>Show what has happened so far.</source>
        <translation>Zeigen, was bisher geschah.</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>JOBS</source>
        <translation>AUFGABEN</translation>
    </message>
    <message>
        <source>LOG</source>
        <translation>PROTOKOLL</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogList</name>
    <message>
        <source>Opened %1.</source>
        <translation>%1 wurde geöffnet.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Warnungen und Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Which messages</source>
        <translation>Welche Meldungen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Copy what is selected, or everything shown</source>
        <translation>Das Gewählte kopieren, oder alles Gezeigte</translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation>Protokoll leeren</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MainWindow</name>
    <message>
        <source>Not every plugin could be loaded.</source>
        <translation>Nicht jede Erweiterung konnte geladen werden.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Find a co&amp;mmand…</source>
        <translation>Be&amp;fehl suchen…</translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature or a page of the manual by a few letters.</source>
        <translation>Befehl, Beispiel, Element oder Seite des Handbuchs an wenigen Buchstaben finden.</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Show everything.</source>
        <translation>Alles zeigen.</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>An&amp;fang</translation>
    </message>
    <message>
        <source>Look at everything as when it was opened.</source>
        <translation>Alles ansehen wie beim Öffnen.</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Come nearer.</source>
        <translation>Näher herangehen.</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Step back.</source>
        <translation>Zurücktreten.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>Blick &amp;von</translation>
    </message>
    <message>
        <source>Look from: %1.</source>
        <translation>Blick von: %1.</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Without perspective: equal lengths look equal.</source>
        <translation>Ohne Perspektive: gleiche Längen sehen gleich aus.</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Show the ground grid.</source>
        <translation>Das Raster am Boden zeigen.</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>No safety copy of %1 can be kept: %2</source>
        <translation>Von %1 kann keine Sicherheitskopie gehalten werden: %2</translation>
    </message>
    <message>
        <source>%1: find a command · Drop files to open them</source>
        <translation>%1: Befehl suchen · Dateien zum Öffnen hierher ziehen</translation>
    </message>
    <message>
        <source>Theme of the &amp;desktop</source>
        <translation>Farben der &amp;Arbeitsumgebung</translation>
    </message>
    <message>
        <source>The window is dark or light as the desktop is.</source>
        <translation>Das Fenster ist dunkel oder hell wie die Arbeitsumgebung.</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>&amp;Dunkle Farben</translation>
    </message>
    <message>
        <source>Light letters on dark ground.</source>
        <translation>Helle Schrift auf dunklem Grund.</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>&amp;Helle Farben</translation>
    </message>
    <message>
        <source>Dark letters on light ground.</source>
        <translation>Dunkle Schrift auf hellem Grund.</translation>
    </message>
    <message>
        <source>zoom to fit;zoom all;frame</source>
        <translation>alles zeigen;einpassen;zoom</translation>
    </message>
    <message>
        <source>orthographic;perspective</source>
        <translation>orthografisch;perspektive</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualText</name>
    <message>
        <source># No such page

The manual has no page &quot;%1&quot;.</source>
        <translation># Diese Seite gibt es nicht

Das Handbuch hat keine Seite „%1“.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualWindow</name>
    <message>
        <source>Blossom manual</source>
        <translation>Blossom-Handbuch</translation>
    </message>
    <message>
        <source>%1 – Blossom manual</source>
        <translation>%1 – Blossom-Handbuch</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Erste Seite</translation>
    </message>
    <message>
        <source>Alt+Home</source>
        <translation>Alt+Home</translation>
    </message>
    <message>
        <source>Nothing in the manual has all of these words.</source>
        <translation>Nichts im Handbuch enthält alle diese Wörter.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasurePanel</name>
    <message>
        <source>Click a face, an edge or a point.</source>
        <translation>Eine Fläche, Kante oder einen Punkt anklicken.</translation>
    </message>
    <message>
        <source>Copy the figures (Ctrl+C)</source>
        <translation>Zahlen kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Delete the measurement (Del)</source>
        <translation>Messung löschen (Entf)</translation>
    </message>
    <message>
        <source>Delete all measurements</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>MEASUREMENTS</source>
        <translation>MESSUNGEN</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasureTool</name>
    <message>
        <source>Click: measure to %1 · Enter: keep as it is</source>
        <translation>Klick: bis %1 messen · Enter: so lassen</translation>
    </message>
    <message>
        <source>Click a second part · Enter: keep as it is · Del: delete</source>
        <translation>Zweites Teil anklicken · Enter: so lassen · Entf: löschen</translation>
    </message>
    <message>
        <source>Click: measure %1</source>
        <translation>Klick: %1 messen</translation>
    </message>
    <message>
        <source>Click a face, an edge or a point to measure it · Esc: finish</source>
        <translation>Fläche, Kante oder Punkt anklicken zum Messen · Esc: beenden</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Measurements</name>
    <message>
        <source>What was measured is no longer in the document.</source>
        <translation>Was gemessen wurde, ist nicht mehr im Dokument.</translation>
    </message>
    <message>
        <source>%1 has no shape at present.</source>
        <translation>%1 hat zurzeit keine Form.</translation>
    </message>
    <message>
        <source>%1, face %2</source>
        <translation>%1, Fläche %2</translation>
    </message>
    <message>
        <source>%1, edge %2</source>
        <translation>%1, Kante %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, Punkt %2</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MouseNavigation</name>
    <message>
        <source>Orbiting</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Panning</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Zooming</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Selects what the box touches</source>
        <translation>Wählt, was der Rahmen berührt</translation>
    </message>
    <message>
        <source>Selects what lies wholly in the box</source>
        <translation>Wählt, was ganz im Rahmen liegt</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Navigation</name>
    <message>
        <source>left and middle drag</source>
        <translation>links oder Mitte ziehen</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>Mitte ziehen</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>rechts ziehen</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>select by a box</source>
        <translation>mit Rahmen wählen</translation>
    </message>
    <message>
        <source>Click: select</source>
        <translation>Klick: wählen</translation>
    </message>
    <message>
        <source>Wheel: zoom</source>
        <translation>Rad: zoomen</translation>
    </message>
    <message>
        <source>Double click: fit</source>
        <translation>Doppelklick: einpassen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::NumberField</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>muss angegeben werden</translation>
    </message>
    <message>
        <source>%1
Drag sideways to change it.</source>
        <translation>%1
Seitwärts ziehen ändert ihn.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::NumbersDialog</name>
    <message>
        <source>Named numbers</source>
        <translation>Benannte Zahlen</translation>
    </message>
    <message>
        <source>A name can be used in every field of this document, as in width/2 + 3 mm. A value without a unit is a plain number.</source>
        <translation>Ein Name kann in jedem Feld dieses Dokuments stehen, etwa breite/2 + 3 mm. Ein Wert ohne Einheit ist eine reine Zahl.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Comes to</source>
        <translation>Ergibt</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>Zeile entfernen</translation>
    </message>
    <message>
        <source>Change named numbers</source>
        <translation>Benannte Zahlen ändern</translation>
    </message>
</context>
<context>
    <name>blossom::ui::OpenDocuments</name>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Painter</name>
    <message>
        <source>The graphics driver offers no OpenGL, which the view needs.</source>
        <translation>Der Grafiktreiber bietet kein OpenGL an, das die Ansicht braucht.</translation>
    </message>
    <message>
        <source>The graphics driver has no OpenGL 3.2, which the view needs.</source>
        <translation>Der Grafiktreiber hat kein OpenGL 3.2, das die Ansicht braucht.</translation>
    </message>
    <message>
        <source>The graphics driver has taken OpenGL away. Save the document, then start Blossom again.</source>
        <translation>Der Grafiktreiber hat OpenGL weggenommen. Das Dokument speichern und Blossom neu starten.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ParameterField</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>Auf die Vorgabe zurücksetzen</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> Der Wert davor bleibt.</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation>Wert einfügen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation>Zurück auf %1</translation>
    </message>
    <message>
        <source>Each with %1.</source>
        <translation>Jeder Eintrag mit %1.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PointTool</name>
    <message>
        <source>Ctrl: no snapping</source>
        <translation>Strg: kein Fang</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Preferences</name>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Colours of the window; system follows the desktop.</source>
        <translation>Farben des Fensters; „system“ folgt der Arbeitsumgebung.</translation>
    </message>
    <message>
        <source>Language of the window, from the next start on.</source>
        <translation>Sprache des Fensters, vom nächsten Start an.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Which mouse buttons turn, shift and zoom the view.</source>
        <translation>Mit welchen Maustasten die Ansicht gedreht, verschoben und vergrößert wird.</translation>
    </message>
    <message>
        <source>Of a document when it is opened.</source>
        <translation>Eines Dokuments, wenn es geöffnet wird.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved changes that is offered after a crash.</source>
        <translation>Von ungespeicherten Änderungen eine Kopie behalten, die nach einem Absturz angeboten wird.</translation>
    </message>
    <message>
        <source>Time between two such copies, in minutes.</source>
        <translation>Zeit zwischen zwei solchen Kopien, in Minuten.</translation>
    </message>
    <message>
        <source>Processor cores to compute with; 0 takes all of them.</source>
        <translation>Prozessorkerne, mit denen gerechnet wird; 0 nimmt alle.</translation>
    </message>
    <message>
        <source>How far what is drawn may lie from the shape itself; 0: chosen by its size. Results and files do not depend on it.</source>
        <translation>Wie weit das Gezeichnete von der Form selbst abweichen darf; 0: nach ihrer Größe gewählt. Ergebnisse und Dateien hängen nicht davon ab.</translation>
    </message>
    <message>
        <source>In which lengths are shown, and what a number without a unit means. Files stay in mm.</source>
        <translation>Worin Längen gezeigt werden und was eine Zahl ohne Einheit bedeutet. Dateien bleiben in mm.</translation>
    </message>
    <message>
        <source>How many dark stripes the surroundings have that zebra stripes mirror.</source>
        <translation>Wie viele dunkle Streifen die Umgebung hat, die sich als Zebrastreifen spiegelt.</translation>
    </message>
    <message>
        <source>How far these stripes are turned from level.</source>
        <translation>Wie weit diese Streifen aus der Waagrechten gedreht sind.</translation>
    </message>
    <message>
        <source>How many curves of constant parameter a face shows in each direction.</source>
        <translation>Wie viele Kurven mit festem Parameter eine Fläche in jeder Richtung zeigt.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PreferencesCommands</name>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>&amp;Tastenkürzel…</translation>
    </message>
    <message>
        <source>Choose the keys of every command.</source>
        <translation>Die Tasten jedes Befehls wählen.</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Look, units, navigation, autosave and threads.</source>
        <translation>Aussehen, Einheiten, Navigation, Sicherung und Threads.</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Reset this page</source>
        <translation>Diese Seite &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PropertyPanel</name>
    <message>
        <source>PROPERTIES</source>
        <translation>EIGENSCHAFTEN</translation>
    </message>
    <message>
        <source>There is nothing in this document yet.</source>
        <translation>In diesem Dokument ist noch nichts.</translation>
    </message>
    <message>
        <source>Select a feature to see what it is made from and what it came to.</source>
        <translation>Ein Element wählen, um zu sehen, woraus es entsteht und was es ergab.</translation>
    </message>
    <message>
        <source>The plugin that makes &quot;%1&quot; is not installed.</source>
        <translation>Die Erweiterung, die „%1“ macht, ist nicht installiert.</translation>
    </message>
    <message>
        <source>INPUTS</source>
        <translation>EINGÄNGE</translation>
    </message>
    <message>
        <source>RESULT</source>
        <translation>ERGEBNIS</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
    <message>
        <source>Another file is still being read or written. Wait for it or cancel it.</source>
        <translation>Eine andere Datei wird noch gelesen oder geschrieben. Abwarten oder abbrechen.</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Datei wird gelesen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>%1 more with the results below.</source>
        <translation>%1 weitere unten bei den Ergebnissen.</translation>
    </message>
    <message>
        <source>%1 is left out: it does not go with %2 · Undo brings it back</source>
        <translation>%1 entfällt: es passt nicht zu %2 · Rückgängig bringt es zurück</translation>
    </message>
</context>
<context>
    <name>blossom::ui::RatioSlider</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Recovery</name>
    <message>
        <source>Looking for unsaved documents</source>
        <translation>Suche nach ungespeicherten Dokumenten</translation>
    </message>
</context>
<context>
    <name>blossom::ui::RecoveryBar</name>
    <message>
        <source>Recover all</source>
        <translation>Alle wiederherstellen</translation>
    </message>
    <message>
        <source>Not now: they are offered again at the next start</source>
        <translation>Nicht jetzt: beim nächsten Start werden sie wieder angeboten</translation>
    </message>
    <message>
        <source>%1, last step: %2</source>
        <translation>%1, letzter Schritt: %2</translation>
    </message>
    <message>
        <source>Was never saved</source>
        <translation>Wurde nie gespeichert</translation>
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
        <source>A document was not saved when Blossom last ended.</source>
        <translation>Ein Dokument war nicht gespeichert, als Blossom zuletzt endete.</translation>
    </message>
    <message>
        <source>%1 documents were not saved when Blossom last ended.</source>
        <translation>%1 Dokumente waren nicht gespeichert, als Blossom zuletzt endete.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ResultRows</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Click to copy</source>
        <translation>Klicken zum Kopieren</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 kopiert</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Copy name and value</source>
        <translation>Name und Wert kopieren</translation>
    </message>
    <message>
        <source>Copy all results</source>
        <translation>Alle Ergebnisse kopieren</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ResultTable</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>from the cache</source>
        <translation>aus dem Speicher</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Out of date: computing…</source>
        <translation>Veraltet: wird berechnet…</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionPanel</name>
    <message>
        <source>Flip</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Cut away the other side (F)</source>
        <translation>Die andere Seite wegschneiden (F)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Show everything whole again (Del)</source>
        <translation>Alles wieder ganz zeigen (Entf)</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Across the x axis (X)</source>
        <translation>Quer zur x-Achse (X)</translation>
    </message>
    <message>
        <source>Across the y axis (Y)</source>
        <translation>Quer zur y-Achse (Y)</translation>
    </message>
    <message>
        <source>Across the z axis (Z)</source>
        <translation>Quer zur z-Achse (Z)</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Parallel to a face that you pick (P)</source>
        <translation>Parallel zu einer gewählten Fläche (P)</translation>
    </message>
    <message>
        <source>Offset of the section</source>
        <translation>Lage des Schnitts</translation>
    </message>
    <message>
        <source>Where it cuts, such as 12.5 or 1/2 in</source>
        <translation>Wo er schneidet, etwa 12.5 oder 1/2 in</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionTool</name>
    <message>
        <source>Click a face: the section becomes parallel to it · Esc: keep the direction</source>
        <translation>Fläche anklicken: der Schnitt wird parallel dazu · Esc: Richtung behalten</translation>
    </message>
    <message>
        <source>Ctrl: in steps of the grid</source>
        <translation>Strg: in Schritten des Rasters</translation>
    </message>
    <message>
        <source>Drag: move the section along its direction</source>
        <translation>Ziehen: Schnitt in seiner Richtung verschieben</translation>
    </message>
    <message>
        <source>Drag the handle · X, Y, Z: direction · P: of a face · F: flip · Up, Down: a step · Del: off · Esc: finish</source>
        <translation>Griff ziehen · X, Y, Z: Richtung · P: einer Fläche · F: umdrehen · Auf, Ab: ein Schritt · Entf: aus · Esc: beenden</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Session</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>The file is written as soon as all of it is computed.</source>
        <translation>Die Datei wird geschrieben, sobald alles berechnet ist.</translation>
    </message>
    <message>
        <source>Computing was cancelled; what was ready is shown.</source>
        <translation>Das Berechnen wurde abgebrochen; was fertig war, ist zu sehen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Import %1 files</source>
        <translation>%1 Dateien importieren</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>%1 in %2 s</source>
        <translation>%1 in %2 s</translation>
    </message>
    <message>
        <source>Exported %1: %2.</source>
        <translation>%1 exportiert: %2.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird wiederhergestellt</translation>
    </message>
    <message>
        <source>%1 is as it was after &quot;%2&quot;.</source>
        <translation>%1 ist, wie es nach „%2“ war.</translation>
    </message>
    <message>
        <source>%1 files, %2</source>
        <translation>%1 Dateien, %2</translation>
    </message>
    <message>
        <source>Cancelled: %1.</source>
        <translation>Abgebrochen: %1.</translation>
    </message>
    <message>
        <source>%1 was not opened here: this document was edited while it was read.</source>
        <translation>%1 wurde hier nicht geöffnet: Dieses Dokument wurde bearbeitet, während die Datei gelesen wurde.</translation>
    </message>
    <message>
        <source>What was edited is kept. Open it again; it comes in a tab of its own.</source>
        <translation>Die Bearbeitung bleibt erhalten. Die Datei noch einmal öffnen; sie kommt in einen eigenen Tab.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ShortcutEditor</name>
    <message>
        <source>Search commands and keys</source>
        <translation>Befehle und Tasten suchen</translation>
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
        <source>&amp;No keys</source>
        <translation>&amp;Keine Tasten</translation>
    </message>
    <message>
        <source>&amp;Standard keys</source>
        <translation>&amp;Übliche Tasten</translation>
    </message>
    <message>
        <source>&amp;Take them from there</source>
        <translation>&amp;Von dort nehmen</translation>
    </message>
    <message>
        <source>Click the keys and press others, or press Enter in the list.</source>
        <translation>Auf die Tasten klicken und andere drücken, oder in der Liste Enter drücken.</translation>
    </message>
    <message>
        <source>Select a command to change its keys.</source>
        <translation>Einen Befehl wählen, um seine Tasten zu ändern.</translation>
    </message>
    <message>
        <source>%1 already belongs to &quot;%2&quot; in %3.</source>
        <translation>%1 gehört schon zu „%2“ in %3.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SnapPlace</name>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>on the edge</source>
        <translation>auf der Kante</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
</context>
<context>
    <name>blossom::ui::StartPage</name>
    <message>
        <source>RECENT</source>
        <translation>ZULETZT</translation>
    </message>
    <message>
        <source>SAMPLES</source>
        <translation>BEISPIELE</translation>
    </message>
    <message>
        <source>Start with a shape</source>
        <translation>Mit einer Form beginnen</translation>
    </message>
    <message>
        <source>Take a sample, or drop files anywhere on the window.</source>
        <translation>Ein Beispiel nehmen, oder Dateien irgendwo auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation>Ein leeres Dokument beginnen.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Start a document with geometry from files.</source>
        <translation>Ein Dokument mit Geometrie aus Dateien beginnen.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Anheften</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Von der Liste nehmen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Show all jobs</source>
        <translation>Alle Aufgaben zeigen</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>%1 jobs: </source>
        <translation>%1 Aufgaben: </translation>
    </message>
    <message>
        <source>What a click in the view selects</source>
        <translation>Was ein Klick in der Ansicht auswählt</translation>
    </message>
    <message>
        <source>Select: %1</source>
        <translation>Auswählen: %1</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SubShapeField</name>
    <message>
        <source>Lost: not found again after an edit. Pick it anew, or remove it.</source>
        <translation>Verloren: nach einer Änderung nicht wiedergefunden. Neu wählen oder entfernen.</translation>
    </message>
    <message>
        <source>Pick in the view: %1</source>
        <translation>In der Ansicht wählen: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>One must be given; pick another one instead.</source>
        <translation>Eines muss angegeben sein; stattdessen ein anderes wählen.</translation>
    </message>
    <message>
        <source>Click every %1 for %2, again to let go; Esc ends</source>
        <translation>Für %2 anklicken: jede %1; noch einmal lässt los; Esc beendet</translation>
    </message>
    <message>
        <source>Click the %1 for %2; Esc ends</source>
        <translation>Für %2 anklicken: %1; Esc beendet</translation>
    </message>
    <message>
        <source>That is not a part of an input of this feature.</source>
        <translation>Das ist kein Teil eines Eingangs dieses Elements.</translation>
    </message>
    <message>
        <source>That is no %1 but a %2.</source>
        <translation>Gebraucht wird: %1; das ist: %2.</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>In der Ansicht wählen</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>%1; pick in the view</source>
        <translation>%1; in der Ansicht wählen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Swatch</name>
    <message>
        <source>Choose another colour</source>
        <translation>Andere Farbe wählen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SwitchBox</name>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TextField</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tile</name>
    <message>
        <source>Pinned</source>
        <translation>Angeheftet</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>Nicht mehr da</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TimelineBar</name>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Frame before</source>
        <translation>Bild davor</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Begin anew at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>Onion skin: show the other frames faintly</source>
        <translation>Zwiebelhaut: die anderen Bilder schwach zeigen</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast it plays</source>
        <translation>Wie schnell abgespielt wird</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Play: makes a sequence of frames first</source>
        <translation>Abspielen: macht zuerst eine Folge von Bildern</translation>
    </message>
    <message>
        <source>Key at this frame</source>
        <translation>Schlüssel bei diesem Bild</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tour</name>
    <message>
        <source>Begin with a sample</source>
        <translation>Mit einem Beispiel beginnen</translation>
    </message>
    <message>
        <source>The start page opens samples and your last documents with one click. Files can be dropped anywhere on the window.</source>
        <translation>Die Startseite öffnet Beispiele und die letzten Dokumente mit einem Klick. Dateien können irgendwo auf das Fenster gezogen werden.</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>Das Dokument</translation>
    </message>
    <message>
        <source>Every feature stands here, above what is made from it, with what it came to below its name. A failing feature says why; the rest of the document lives on.</source>
        <translation>Hier steht jedes Element, über dem, was aus ihm entsteht; unter seinem Namen, was es ergab. Ein gescheitertes sagt, warum; der Rest des Dokuments lebt weiter.</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>What is selected shows its parameters and its result. Values may be expressions with units, such as 3cm + 1/2 in, and every change can be undone.</source>
        <translation>Das Gewählte zeigt seine Parameter und sein Ergebnis. Werte dürfen Ausdrücke mit Einheiten sein, etwa 3cm + 1/2 in, und jede Änderung lässt sich zurücknehmen.</translation>
    </message>
    <message>
        <source>Canvas and palette</source>
        <translation>Zeichenfläche und Palette</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do.</source>
        <translation>Ziehen dreht, das Rad holt näher, ein Klick wählt. Die Statuszeile sagt immer, was die Maus täte.</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do. %1 finds every command by name.</source>
        <translation>Ziehen dreht, das Rad holt näher, ein Klick wählt. Die Statuszeile sagt immer, was die Maus täte. %1 findet jeden Befehl beim Namen.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TourBubble</name>
    <message>
        <source>&amp;Skip</source>
        <translation>Über&amp;springen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
</context>
<context>
    <name>blossom::ui::UnsavedDialog</name>
    <message>
        <source>Save all</source>
        <translation>Alle speichern</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 documents have changes that are not saved.</source>
        <translation>%1 Dokumente haben Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Those that are ticked are saved; the changes of the others are lost.</source>
        <translation>Angekreuzte werden gespeichert; die Änderungen der anderen gehen verloren.</translation>
    </message>
    <message>
        <source>Discard all</source>
        <translation>Alle verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save %1 of %2</source>
        <translation>%1 von %2 speichern</translation>
    </message>
</context>
<context>
    <name>blossom::ui::VectorField</name>
    <message>
        <source>Pick a point in the view</source>
        <translation>Punkt in der Ansicht wählen</translation>
    </message>
    <message>
        <source>Pick a face in the view; its normal is taken</source>
        <translation>Fläche in der Ansicht wählen; ihre Normale wird genommen</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> Der Wert davor bleibt.</translation>
    </message>
    <message>
        <source>Click where %1 is to be; Esc ends</source>
        <translation>Anklicken, wo %1 sein soll; Esc beendet</translation>
    </message>
    <message>
        <source>Click a face whose normal is to be %1; Esc ends</source>
        <translation>Fläche anklicken, deren Normale %1 sein soll; Esc beendet</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>In der Ansicht wählen</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCommands</name>
    <message>
        <source>Select</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>F&amp;eatures</source>
        <translation>&amp;Elemente</translation>
    </message>
    <message>
        <source>A click in the view selects whole features.</source>
        <translation>Ein Klick in der Ansicht wählt ganze Elemente.</translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation>&amp;Flächen</translation>
    </message>
    <message>
        <source>A click in the view selects faces.</source>
        <translation>Ein Klick in der Ansicht wählt Flächen.</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>A click in the view selects edges.</source>
        <translation>Ein Klick in der Ansicht wählt Kanten.</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punkte</translation>
    </message>
    <message>
        <source>A click in the view selects points.</source>
        <translation>Ein Klick in der Ansicht wählt Punkte.</translation>
    </message>
    <message>
        <source>&amp;Any part</source>
        <translation>&amp;Jedes Teil</translation>
    </message>
    <message>
        <source>A click in the view selects the nearest face, edge or point.</source>
        <translation>Ein Klick in der Ansicht wählt die nächste Fläche, Kante oder den nächsten Punkt.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation>Schattiert mit &amp;Kanten</translation>
    </message>
    <message>
        <source>Draw faces and their edges.</source>
        <translation>Flächen und ihre Kanten zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Schattiert</translation>
    </message>
    <message>
        <source>Draw faces alone.</source>
        <translation>Nur Flächen zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Draw edges alone.</source>
        <translation>Nur Kanten zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure lengths, distances, angles, radii and areas by clicking.</source>
        <translation>Längen, Abstände, Winkel, Radien und Flächen durch Klicken messen.</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>&amp;Schnitt</translation>
    </message>
    <message>
        <source>Cut the model open with a plane that can be dragged.</source>
        <translation>Das Modell mit einer verschiebbaren Ebene aufschneiden.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Ab&amp;spielen oder anhalten</translation>
    </message>
    <message>
        <source>Run through the frames of the sequence shown.</source>
        <translation>Die Bilder der gezeigten Folge durchlaufen.</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>Show the next frame of the sequence.</source>
        <translation>Das nächste Bild der Folge zeigen.</translation>
    </message>
    <message>
        <source>Pre&amp;vious frame</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>Show the frame before.</source>
        <translation>Das Bild davor zeigen.</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>&amp;Zwiebelhaut</translation>
    </message>
    <message>
        <source>Show the other frames of the sequence faintly.</source>
        <translation>Die anderen Bilder der Folge schwach zeigen.</translation>
    </message>
    <message>
        <source>No sequence is shown: a morph with several frames makes one.</source>
        <translation>Es wird keine Folge gezeigt: Ein Morph mit mehreren Bildern macht eine.</translation>
    </message>
    <message>
        <source>dimension;distance;ruler;length;angle</source>
        <translation>maß;abstand;lineal;länge;winkel</translation>
    </message>
    <message>
        <source>clip;cross section;cutaway</source>
        <translation>schneiden;querschnitt;aufschneiden</translation>
    </message>
    <message>
        <source>&amp;Zebra stripes</source>
        <translation>&amp;Zebrastreifen</translation>
    </message>
    <message>
        <source>Faces mirror striped surroundings: stripes bend where surfaces do.</source>
        <translation>Flächen spiegeln eine gestreifte Umgebung: Die Streifen biegen sich, wo Flächen es tun.</translation>
    </message>
    <message>
        <source>reflection;continuity;surface quality;highlight lines</source>
        <translation>spiegelung;reflexion;stetigkeit;flächenqualität;glanzlinien</translation>
    </message>
    <message>
        <source>&amp;Gaussian curvature</source>
        <translation>&amp;Gaußsche Krümmung</translation>
    </message>
    <message>
        <source>Colours of the product of the principal curvatures: domes, saddles, and what can be unrolled.</source>
        <translation>Farben für das Produkt der Hauptkrümmungen: Kuppeln, Sättel und was sich abwickeln lässt.</translation>
    </message>
    <message>
        <source>surface quality;colours;developable</source>
        <translation>flächenqualität;farben;abwickelbar</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>&amp;Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Colours of the mean of the principal curvatures: bulges, hollows and minimal surfaces.</source>
        <translation>Farben für das Mittel der Hauptkrümmungen: Buckel, Mulden und Minimalflächen.</translation>
    </message>
    <message>
        <source>surface quality;colours</source>
        <translation>flächenqualität;farben</translation>
    </message>
    <message>
        <source>&amp;Largest curvature</source>
        <translation>G&amp;rößte Krümmung</translation>
    </message>
    <message>
        <source>Colours of the tightest bend at every place: its radius limits tools and offsets.</source>
        <translation>Farben für die engste Biegung an jeder Stelle: Ihr Radius begrenzt Werkzeuge und Parallelen.</translation>
    </message>
    <message>
        <source>surface quality;colours;radius;principal curvature</source>
        <translation>flächenqualität;farben;radius;hauptkrümmung</translation>
    </message>
    <message>
        <source>&amp;Iso-curves</source>
        <translation>&amp;Iso-Kurven</translation>
    </message>
    <message>
        <source>Draw curves of constant parameter on the faces.</source>
        <translation>Kurven mit festem Parameter auf die Flächen zeichnen.</translation>
    </message>
    <message>
        <source>isoparametric;parameter lines;surface quality</source>
        <translation>isoparametrisch;parameterlinien;flächenqualität</translation>
    </message>
    <message>
        <source>Surface &amp;quality</source>
        <translation>Flächen&amp;qualität</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCube</name>
    <message>
        <source>Click: look from %1</source>
        <translation>Klick: Blick von %1</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewWidget</name>
    <message>
        <source>grid %1</source>
        <translation>Raster %1</translation>
    </message>
    <message>
        <source>x %1   y %2 %3   ·   %4</source>
        <translation>x %1   y %2 %3   ·   %4</translation>
    </message>
    <message>
        <source>x %1   y %2   z %3 %4</source>
        <translation>x %1   y %2   z %3 %4</translation>
    </message>
</context>
</TS>
