<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Figures</name>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Certified</source>
        <translation>Belegt</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>Closing in u</source>
        <translation>Geschlossen in u</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>Durchdringt sich</translation>
    </message>
    <message>
        <source>Crosses itself at</source>
        <translation>Durchdringt sich bei</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Degree in u</source>
        <translation>Grad in u</translation>
    </message>
    <message>
        <source>Degree in v</source>
        <translation>Grad in v</translation>
    </message>
    <message>
        <source>Depth of the crossing</source>
        <translation>Tiefe der Durchdringung</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Tiefen</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>Entities</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Eintauchstellen</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Free points</source>
        <translation>Freie Punkte</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Helper process</source>
        <translation>Hilfsprozess</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
    <message>
        <source>Knots inserted</source>
        <translation>Eingefügte Knoten</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Max after</source>
        <translation>Größter Abstand nachher</translation>
    </message>
    <message>
        <source>Max before</source>
        <translation>Größter Abstand vorher</translation>
    </message>
    <message>
        <source>Moved poles</source>
        <translation>Bewegte Pole</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Off the motion</source>
        <translation>Neben der Bewegung</translation>
    </message>
    <message>
        <source>Outside change</source>
        <translation>Änderung außerhalb</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>Poles in u</source>
        <translation>Pole in u</translation>
    </message>
    <message>
        <source>Poles in v</source>
        <translation>Pole in v</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>Erreichbar</translation>
    </message>
    <message>
        <source>Remainder</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Residue</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>Grat</translation>
    </message>
    <message>
        <source>Rms after</source>
        <translation>Mittlerer Abstand nachher</translation>
    </message>
    <message>
        <source>Rms before</source>
        <translation>Mittlerer Abstand vorher</translation>
    </message>
    <message>
        <source>Smallest weight</source>
        <translation>Kleinstes Gewicht</translation>
    </message>
    <message>
        <source>Smallest weight at</source>
        <translation>Kleinstes Gewicht bei</translation>
    </message>
    <message>
        <source>Min |xu × xv|</source>
        <translation>Min. |xu × xv|</translation>
    </message>
    <message>
        <source>Min |xu × xv| at</source>
        <translation>Min. |xu × xv| bei</translation>
    </message>
    <message>
        <source>Spans in u</source>
        <translation>Abschnitte in u</translation>
    </message>
    <message>
        <source>Spans in v</source>
        <translation>Abschnitte in v</translation>
    </message>
    <message>
        <source>Splines</source>
        <translation>Splines</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Sums</source>
        <translation>Summen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Uncertified</source>
        <translation>Unbelegt</translation>
    </message>
    <message>
        <source>Uncut</source>
        <translation>Ungeschnitten</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>medial axis</source>
        <translation>Mittelachse</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>region</source>
        <translation>Gebiet</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>span</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>spans</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>toolpath</source>
        <translation>Werkzeugweg</translation>
    </message>
    <message>
        <source>sequence</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>Area by vertices</source>
        <translation>Fläche über Ecken</translation>
    </message>
    <message>
        <source>Area by fields</source>
        <translation>Fläche über Felder</translation>
    </message>
    <message>
        <source>Area by sums</source>
        <translation>Fläche über Summen</translation>
    </message>
    <message>
        <source>Time by vertices</source>
        <translation>Zeit über Ecken</translation>
    </message>
    <message>
        <source>Time by fields</source>
        <translation>Zeit über Felder</translation>
    </message>
    <message>
        <source>Time by sums</source>
        <translation>Zeit über Summen</translation>
    </message>
    <message>
        <source>Crossings by vertices</source>
        <translation>Kreuzungen über Ecken</translation>
    </message>
    <message>
        <source>Clamps</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Stock x</source>
        <translation>Rohteil x</translation>
    </message>
    <message>
        <source>Stock y</source>
        <translation>Rohteil y</translation>
    </message>
    <message>
        <source>Stock z</source>
        <translation>Rohteil z</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Moves outside travel</source>
        <translation>Wege außerhalb des Verfahrwegs</translation>
    </message>
</context>
<context>
    <name>Registry</name>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Makes a preview of so many cells along the longest side, which is quick for any shapes; 0: the solid itself.</source>
        <translation>Macht eine Vorschau aus so vielen Zellen entlang der längsten Seite, was für alle Formen schnell geht; 0: der Körper selbst.</translation>
    </message>
    <message>
        <source>Solid from mesh</source>
        <translation>Körper aus Netz</translation>
    </message>
    <message>
        <source>The solid that a closed mesh bounds; what lies in one plane is one face.</source>
        <translation>Der Körper, den ein geschlossenes Netz begrenzt; was in einer Ebene liegt, ist eine Fläche.</translation>
    </message>
    <message>
        <source>A closed mesh of at most 20,000 faces.</source>
        <translation>Ein geschlossenes Netz mit höchstens 20.000 Flächen.</translation>
    </message>
    <message>
        <source>a mesh to make a solid of</source>
        <translation>ein Netz, aus dem ein Körper wird</translation>
    </message>
    <message>
        <source>volume preserving</source>
        <translation>volumentreu</translation>
    </message>
    <message>
        <source>Scale each solid about its middle so that its volume blends those of the shapes.</source>
        <translation>Jeden Körper um seine Mitte so skalieren, dass sein Volumen zwischen denen der Formen übergeht.</translation>
    </message>
    <message>
        <source>families</source>
        <translation>Familien</translation>
    </message>
    <message>
        <source>outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>What the picture shows of how the sum is made: the facets coloured by what they are made of, with the reflex corners, and also the outlines of all facets, of which those inside are left out.</source>
        <translation>Was das Bild davon zeigt, wie die Summe entsteht: die Facetten, gefärbt nach dem, woraus sie bestehen, mit den einspringenden Ecken, und dazu die Umrisse aller Facetten, von denen die inneren wegfallen.</translation>
    </message>
    <message>
        <source>0: 2 mm more than the pocket is deep, or as thick as the solid.</source>
        <translation>0: 2 mm mehr, als die Tasche tief ist, oder so dick wie der Körper.</translation>
    </message>
    <message>
        <source>0: the tool that the program names.</source>
        <translation>0: das Werkzeug, das das Programm nennt.</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>a 10,000th of each shape&apos;s size and a 500th of its thickness, at most 0.01 mm</source>
        <translation>ein 10.000stel der Größe jeder Form und ein 500stel ihrer Dicke, höchstens 0,01 mm</translation>
    </message>
    <message>
        <source>A ball of triangles about the origin, to add to a solid or to melt it by.</source>
        <translation>Eine Kugel aus Dreiecken um den Ursprung, um sie zu einem Körper zu addieren oder ihn damit abzuschmelzen.</translation>
    </message>
    <message>
        <source>A box with three edge lengths.</source>
        <translation>Ein Quader mit drei Kantenlängen.</translation>
    </message>
    <message>
        <source>a cage to pull</source>
        <translation>einen Käfig zum Ziehen</translation>
    </message>
    <message>
        <source>a cage to smooth</source>
        <translation>einen Käfig zum Glätten</translation>
    </message>
    <message>
        <source>A cage whose limit surface or curve is pulled to a target near it; parts farther away stay.</source>
        <translation>Ein Käfig, dessen Grenzfläche oder -kurve zu einem nahen Ziel gezogen ist; weiter entfernte Teile bleiben.</translation>
    </message>
    <message>
        <source>A point of the plane, out of which a shape can grow in a morph.</source>
        <translation>Ein Punkt der Ebene, aus dem in einem Morph eine Form wachsen kann.</translation>
    </message>
    <message>
        <source>Where it is, in the plane z = 0.</source>
        <translation>Wo er liegt, in der Ebene z = 0.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>A circle, as one exact arc.</source>
        <translation>Ein Kreis als ein exakter Bogen.</translation>
    </message>
    <message>
        <source>a closed hollow</source>
        <translation>ein geschlossener Hohlraum</translation>
    </message>
    <message>
        <source>A coarse cage refined to a smooth surface or curve.</source>
        <translation>Ein grober Käfig, verfeinert zu einer glatten Fläche oder Kurve.</translation>
    </message>
    <message>
        <source>A cone, pointed or cut off.</source>
        <translation>Ein Kegel, spitz oder abgeschnitten.</translation>
    </message>
    <message>
        <source>A curve through points in space, drawn over a shape as its target.</source>
        <translation>Eine Kurve durch Punkte im Raum, als Ziel über eine Form gezeichnet.</translation>
    </message>
    <message>
        <source>A drawn outline of lines, arcs and splines; a region when it is closed.</source>
        <translation>Ein gezeichneter Umriss aus Linien, Bögen und Splines; geschlossen ist er eine Fläche.</translation>
    </message>
    <message>
        <source>A flat, closed, star-shaped outline to be the section; without one it is round.</source>
        <translation>Ein ebener, geschlossener, sternförmiger Umriss als Querschnitt; ohne ihn ist er rund.</translation>
    </message>
    <message>
        <source>A height for each section, instead of the spacing.</source>
        <translation>Eine Höhe für jeden Querschnitt, statt des Abstands.</translation>
    </message>
    <message>
        <source>A mesh, with its creases, or a control polygon.</source>
        <translation>Ein Netz mit seinen Falten oder ein Kontrollpolygon.</translation>
    </message>
    <message>
        <source>A motion that carries a section along a curve without spinning it, ready to be pulled.</source>
        <translation>Eine Bewegung, die einen Querschnitt ohne Drall entlang einer Kurve führt, bereit zum Ziehen.</translation>
    </message>
    <message>
        <source>A motion that sweeps a plain shape, with poles to pull it by: a beginning without any file.</source>
        <translation>Eine Bewegung, die eine einfache Form überstreicht, mit Polen zum Ziehen: ein Anfang ohne Datei.</translation>
    </message>
    <message>
        <source>a motion to edit</source>
        <translation>eine Bewegung zum Bearbeiten</translation>
    </message>
    <message>
        <source>a motion to refine</source>
        <translation>eine Bewegung zum Verfeinern</translation>
    </message>
    <message>
        <source>a motion to sweep with</source>
        <translation>eine Bewegung für den Sweep</translation>
    </message>
    <message>
        <source>A motion whose frame is turned about an axis at some places.</source>
        <translation>Eine Bewegung, deren Bezugssystem an einigen Stellen um eine Achse gedreht ist.</translation>
    </message>
    <message>
        <source>A motion whose swept surface is pulled to targets, by moving, turning and scaling.</source>
        <translation>Eine Bewegung, deren überstrichene Fläche durch Verschieben, Drehen und Skalieren zu Zielen gezogen wird.</translation>
    </message>
    <message>
        <source>A motion with single poles and weights of trajectory, orientation and scaling changed.</source>
        <translation>Eine Bewegung, in der einzelne Pole und Gewichte von Bahn, Orientierung und Skalierung geändert sind.</translation>
    </message>
    <message>
        <source>A motion: trajectory, orientation and scaling, and its edits.</source>
        <translation>Eine Bewegung: Bahn, Orientierung und Skalierung, und ihre Änderungen.</translation>
    </message>
    <message>
        <source>A motion: trajectory, orientation and scaling.</source>
        <translation>Eine Bewegung: Bahn, Orientierung und Skalierung.</translation>
    </message>
    <message>
        <source>A place on the limit shape, or near it, before the deformation.</source>
        <translation>Eine Stelle auf der Grenzform oder nahe an ihr, vor der Verformung.</translation>
    </message>
    <message>
        <source>A point in the mirror plane.</source>
        <translation>Ein Punkt in der Spiegelebene.</translation>
    </message>
    <message>
        <source>A point that an arc passes; points that a spline passes on its way.</source>
        <translation>Ein Punkt, durch den ein Bogen geht; Punkte, durch die ein Spline auf seinem Weg geht.</translation>
    </message>
    <message>
        <source>A point that the axis passes through.</source>
        <translation>Ein Punkt, durch den die Achse geht.</translation>
    </message>
    <message>
        <source>A point that this axis passes through.</source>
        <translation>Ein Punkt, durch den diese Achse geht.</translation>
    </message>
    <message>
        <source>a program to simulate</source>
        <translation>ein Programm zum Simulieren</translation>
    </message>
    <message>
        <source>A rectangle with sharp or rounded corners.</source>
        <translation>Ein Rechteck mit scharfen oder runden Ecken.</translation>
    </message>
    <message>
        <source>a region to combine</source>
        <translation>eine Fläche zum Verknüpfen</translation>
    </message>
    <message>
        <source>a region to follow or to sweep</source>
        <translation>einen Bereich zum Verfolgen oder Ziehen</translation>
    </message>
    <message>
        <source>A region, closed curves, or a solid of which a flat face is chosen.</source>
        <translation>Eine Fläche, geschlossene Kurven oder ein Körper, von dem eine ebene Seite gewählt wird.</translation>
    </message>
    <message>
        <source>A region, curves or a flat face.</source>
        <translation>Eine Fläche, Kurven oder eine ebene Seite.</translation>
    </message>
    <message>
        <source>a region, curves or a point to add</source>
        <translation>eine Fläche, Kurven oder einen Punkt zum Addieren</translation>
    </message>
    <message>
        <source>a region, or what has to fit inside</source>
        <translation>eine Fläche oder was hineinpassen muss</translation>
    </message>
    <message>
        <source>A regular polygon.</source>
        <translation>Ein regelmäßiges Vieleck.</translation>
    </message>
    <message>
        <source>A ring of round section.</source>
        <translation>Ein Ring mit rundem Querschnitt.</translation>
    </message>
    <message>
        <source>A round cylinder, or a wedge of one.</source>
        <translation>Ein runder Zylinder oder ein Keil davon.</translation>
    </message>
    <message>
        <source>a sequence or a shape to join</source>
        <translation>eine Folge oder Form zum Verbinden</translation>
    </message>
    <message>
        <source>A sequence played backwards, with a slow begin or end, or in another number of frames.</source>
        <translation>Eine Folge, rückwärts gespielt, mit langsamem Anfang oder Ende oder mit einer anderen Zahl von Bildern.</translation>
    </message>
    <message>
        <source>a sequence to retime</source>
        <translation>eine Folge, die neu getaktet wird</translation>
    </message>
    <message>
        <source>a sequence to take a frame out of</source>
        <translation>eine Folge, aus der ein Bild genommen wird</translation>
    </message>
    <message>
        <source>A shape added to itself several times, which fills towards its convex hull.</source>
        <translation>Eine Form, mehrmals zu sich selbst addiert; sie füllt sich zu ihrer konvexen Hülle hin.</translation>
    </message>
    <message>
        <source>A shape and its mirror image in a plane.</source>
        <translation>Eine Form und ihr Spiegelbild an einer Ebene.</translation>
    </message>
    <message>
        <source>A shape moved, turned and scaled.</source>
        <translation>Eine Form, verschoben, gedreht und skaliert.</translation>
    </message>
    <message>
        <source>A shape read from a file.</source>
        <translation>Eine Form, aus einer Datei gelesen.</translation>
    </message>
    <message>
        <source>a shape to add</source>
        <translation>eine Form zum Addieren</translation>
    </message>
    <message>
        <source>a shape to add to</source>
        <translation>eine Form, zu der addiert wird</translation>
    </message>
    <message>
        <source>a shape to change it with</source>
        <translation>eine Form, mit der er verändert wird</translation>
    </message>
    <message>
        <source>a shape to enclose</source>
        <translation>eine Form zum Umschließen</translation>
    </message>
    <message>
        <source>a shape to mirror</source>
        <translation>eine Form zum Spiegeln</translation>
    </message>
    <message>
        <source>a shape to morph</source>
        <translation>eine Form zum Morphen</translation>
    </message>
    <message>
        <source>a shape to move</source>
        <translation>eine Form zum Verschieben</translation>
    </message>
    <message>
        <source>a shape to repeat</source>
        <translation>eine Form zum Wiederholen</translation>
    </message>
    <message>
        <source>A shape with an area, then what has to fit inside: an outline, open curves or points.</source>
        <translation>Eine Form mit Fläche, dann was hineinpassen muss: ein Umriss, offene Kurven oder Punkte.</translation>
    </message>
    <message>
        <source>A shape written down in one word, such as ball:5:3.</source>
        <translation>Eine Form in einem Wort, etwa ball:5:3.</translation>
    </message>
    <message>
        <source>A slot with round ends, as a cutter leaves it.</source>
        <translation>Ein Langloch mit runden Enden, wie ein Fräser es hinterlässt.</translation>
    </message>
    <message>
        <source>A smooth curve through the points; else straight lines.</source>
        <translation>Eine glatte Kurve durch die Punkte; sonst gerade Linien.</translation>
    </message>
    <message>
        <source>A solid grown by a ball or another shape: every point within the radius of it.</source>
        <translation>Ein um eine Kugel oder eine andere Form gewachsener Körper: alle Punkte innerhalb des Radius um ihn.</translation>
    </message>
    <message>
        <source>A solid hollowed out to walls of even thickness.</source>
        <translation>Ein Körper, ausgehöhlt bis auf gleichmäßig dicke Wände.</translation>
    </message>
    <message>
        <source>A solid melted by a ball or another shape: every point farther than the radius from its outside.</source>
        <translation>Ein um eine Kugel oder eine andere Form geschmolzener Körper: alle Punkte, die weiter als der Radius von außen entfernt sind.</translation>
    </message>
    <message>
        <source>a solid or region to combine</source>
        <translation>einen Körper oder eine Fläche zum Verknüpfen</translation>
    </message>
    <message>
        <source>A solid over an outline, straight or tapered.</source>
        <translation>Ein Körper über einem Umriss, gerade oder schräg.</translation>
    </message>
    <message>
        <source>A solid that an outline sweeps along a path.</source>
        <translation>Ein Körper, den ein Umriss entlang eines Pfades überstreicht.</translation>
    </message>
    <message>
        <source>A solid that an outline sweeps when it turns about an axis.</source>
        <translation>Ein Körper, den ein Umriss überstreicht, der sich um eine Achse dreht.</translation>
    </message>
    <message>
        <source>A solid through two or more outlines.</source>
        <translation>Ein Körper durch zwei oder mehr Umrisse.</translation>
    </message>
    <message>
        <source>solids to morph</source>
        <translation>Körper zum Überblenden</translation>
    </message>
    <message>
        <source>a solid to bevel</source>
        <translation>einen Körper zum Anfasen</translation>
    </message>
    <message>
        <source>a solid to change</source>
        <translation>einen Körper zum Verändern</translation>
    </message>
    <message>
        <source>a solid to grow or melt</source>
        <translation>einen Körper zum Aufblasen oder Abschmelzen</translation>
    </message>
    <message>
        <source>a solid to hollow out</source>
        <translation>einen Körper zum Aushöhlen</translation>
    </message>
    <message>
        <source>a solid to round</source>
        <translation>einen Körper zum Verrunden</translation>
    </message>
    <message>
        <source>A solid with edges cut off by flat strips.</source>
        <translation>Ein Körper, dessen Kanten durch flache Streifen gebrochen sind.</translation>
    </message>
    <message>
        <source>A solid with rounded edges.</source>
        <translation>Ein Körper mit runden Kanten.</translation>
    </message>
    <message>
        <source>A solid with the places filled that a shape cannot reach from outside: narrow slots and inner edges.</source>
        <translation>Ein Körper, gefüllt, wo eine Form von außen nicht hinkommt: enge Schlitze und innere Kanten.</translation>
    </message>
    <message>
        <source>A solid.</source>
        <translation>Ein Körper.</translation>
    </message>
    <message>
        <source>A sphere, or a wedge of one.</source>
        <translation>Eine Kugel oder ein Keil davon.</translation>
    </message>
    <message>
        <source>A star with straight sides.</source>
        <translation>Ein Stern mit geraden Seiten.</translation>
    </message>
    <message>
        <source>A text in an installed font, with the exact outlines of its letters.</source>
        <translation>Ein Text in einer installierten Schrift, mit den genauen Umrissen ihrer Buchstaben.</translation>
    </message>
    <message>
        <source>A toolpath or a G-code program. In a document, a program that starts no spindle (M3) and names no tool (T) is one when it is imported as &quot;toolpath&quot;.</source>
        <translation>Ein Werkzeugweg oder ein G-Code-Programm. In einem Dokument gilt ein Programm, das keine Spindel startet (M3) und kein Werkzeug nennt (T), wenn es als „Werkzeugweg“ importiert ist.</translation>
    </message>
    <message>
        <source>A toolpath that clears a part down to a depth, islands left standing.</source>
        <translation>Ein Werkzeugweg, der ein Teil bis auf eine Tiefe ausräumt; Inseln bleiben stehen.</translation>
    </message>
    <message>
        <source>Across: the diameter of the ends.</source>
        <translation>Quer: der Durchmesser der Enden.</translation>
    </message>
    <message>
        <source>Additional height in the opposite direction.</source>
        <translation>Zusätzliche Höhe in der Gegenrichtung.</translation>
    </message>
    <message>
        <source>align</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>All positions of the second shape&apos;s origin for which it stays inside the first.</source>
        <translation>Alle Lagen des Ursprungs der zweiten Form, in denen sie in der ersten bleibt.</translation>
    </message>
    <message>
        <source>all sharp edges</source>
        <translation>alle scharfen Kanten</translation>
    </message>
    <message>
        <source>along</source>
        <translation>entlang</translation>
    </message>
    <message>
        <source>Along the axes x, y and z of the moving frame.</source>
        <translation>Entlang der Achsen x, y und z des bewegten Bezugssystems.</translation>
    </message>
    <message>
        <source>Along x when it is not turned.</source>
        <translation>In x, wenn es nicht gedreht ist.</translation>
    </message>
    <message>
        <source>Along y when it is not turned.</source>
        <translation>In y, wenn es nicht gedreht ist.</translation>
    </message>
    <message>
        <source>An ellipse, as an exact rational curve; a circle when its half-axes are equal.</source>
        <translation>Eine Ellipse als exakte rationale Kurve; bei gleichen Halbachsen ein Kreis.</translation>
    </message>
    <message>
        <source>an outline of the solid</source>
        <translation>einen Umriss des Körpers</translation>
    </message>
    <message>
        <source>an outline or solid to cut a pocket into</source>
        <translation>einen Umriss oder Körper für die Tasche</translation>
    </message>
    <message>
        <source>an outline to be the section</source>
        <translation>einen Umriss als Querschnitt</translation>
    </message>
    <message>
        <source>an outline to extrude</source>
        <translation>einen Umriss zum Extrudieren</translation>
    </message>
    <message>
        <source>an outline to find the medial axis of</source>
        <translation>einen Umriss, dessen Mittelachse gesucht wird</translation>
    </message>
    <message>
        <source>an outline to loft through</source>
        <translation>einen Umriss für den Übergang</translation>
    </message>
    <message>
        <source>an outline to move along a path</source>
        <translation>einen Umriss, der einem Pfad folgt</translation>
    </message>
    <message>
        <source>an outline to offset</source>
        <translation>einen Umriss für die Parallele</translation>
    </message>
    <message>
        <source>an outline to revolve</source>
        <translation>einen Umriss zum Rotieren</translation>
    </message>
    <message>
        <source>An outline with the places filled that a shape cannot reach from outside: slots and inner corners.</source>
        <translation>Ein Umriss, an dem gefüllt ist, was eine Form von außen nicht erreicht: Schlitze und innere Ecken.</translation>
    </message>
    <message>
        <source>An outline, then the shape that moves inside it.</source>
        <translation>Ein Umriss, dann die Form, die sich darin bewegt.</translation>
    </message>
    <message>
        <source>An outline, then the shape that moves outside it, turned by 180 degrees.</source>
        <translation>Ein Umriss, dann die Form, die sich außen bewegt, um 180 Grad gedreht.</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>Bezugspunkt</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle from the x axis to the first corner.</source>
        <translation>Winkel von der x-Achse zur ersten Ecke.</translation>
    </message>
    <message>
        <source>Angle from the x axis to the first half-axis.</source>
        <translation>Winkel von der x-Achse zur ersten Halbachse.</translation>
    </message>
    <message>
        <source>Angle from the x axis to the first point.</source>
        <translation>Winkel von der x-Achse zur ersten Spitze.</translation>
    </message>
    <message>
        <source>Angle from the x axis to the length.</source>
        <translation>Winkel von der x-Achse zur Länge.</translation>
    </message>
    <message>
        <source>Angle of ramp and helix.</source>
        <translation>Winkel von Rampe und Helix.</translation>
    </message>
    <message>
        <source>Angle of revolution; below 0: clockwise.</source>
        <translation>Drehwinkel; unter 0: im Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Angle of the turn, at most 360 degrees.</source>
        <translation>Winkel der Drehung, höchstens 360 Grad.</translation>
    </message>
    <message>
        <source>animate</source>
        <translation>animieren</translation>
    </message>
    <message>
        <source>ap203</source>
        <translation>AP 203</translation>
    </message>
    <message>
        <source>ap214</source>
        <translation>AP 214</translation>
    </message>
    <message>
        <source>ap242</source>
        <translation>AP 242</translation>
    </message>
    <message>
        <source>Application protocol of the file.</source>
        <translation>Anwendungsprotokoll der Datei.</translation>
    </message>
    <message>
        <source>approach</source>
        <translation>Anfahrhöhe</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>area preserving</source>
        <translation>flächentreu</translation>
    </message>
    <message>
        <source>as</source>
        <translation>als</translation>
    </message>
    <message>
        <source>ascii</source>
        <translation>ASCII</translation>
    </message>
    <message>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis for a turn to the opposite side; 0,0,0 for none.</source>
        <translation>Achse für eine Drehung auf die Gegenseite; 0,0,0 für keine.</translation>
    </message>
    <message>
        <source>Axis in space, through the trajectory.</source>
        <translation>Achse im Raum, durch die Bahn.</translation>
    </message>
    <message>
        <source>Axis in space.</source>
        <translation>Achse im Raum.</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Facettenkugel</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Grundfläche</translation>
    </message>
    <message>
        <source>blossom</source>
        <translation>Blossom</translation>
    </message>
    <message>
        <source>bold</source>
        <translation>fett</translation>
    </message>
    <message>
        <source>bold-italic</source>
        <translation>fett kursiv</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>Boolesche Operation</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>bottom radius</source>
        <translation>Radius unten</translation>
    </message>
    <message>
        <source>bottom-up</source>
        <translation>von unten nach oben</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>brep</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>catmull-clark</source>
        <translation>Catmull-Clark</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells of the distance fields along the longer side of the shapes.</source>
        <translation>Zellen der Abstandsfelder entlang der längeren Seite der Formen.</translation>
    </message>
    <message>
        <source>center</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>centroid</source>
        <translation>Schwerpunkt</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>chord</source>
        <translation>Sehnenfehler</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>circular</source>
        <translation>kreisförmig</translation>
    </message>
    <message>
        <source>circumscribed</source>
        <translation>umbeschrieben</translation>
    </message>
    <message>
        <source>climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>Close both ends; off: an open sheet.</source>
        <translation>Schließt beide Enden; aus: eine offene Fläche.</translation>
    </message>
    <message>
        <source>Close the ends of a motion that closes in u and make a solid.</source>
        <translation>Schließt die Enden einer Bewegung, die in u geschlossen ist, und macht einen Körper.</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closing of an outline</source>
        <translation>Schließen eines Umrisses</translation>
    </message>
    <message>
        <source>Colours of canvas and edges.</source>
        <translation>Farben von Hintergrund und Kanten.</translation>
    </message>
    <message>
        <source>column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Column of the pole along v, counted from 0.</source>
        <translation>Spalte des Pols in v, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>control</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>control points</source>
        <translation>Kontrollpunkte</translation>
    </message>
    <message>
        <source>Control shapes, first to last; single points, too, out of which shapes grow.</source>
        <translation>Kontrollformen, von der ersten bis zur letzten; auch einzelne Punkte, aus denen Formen wachsen.</translation>
    </message>
    <message>
        <source>conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>konvex</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Konvexe Hülle</translation>
    </message>
    <message>
        <source>Copies of a shape in rows or round an axis.</source>
        <translation>Kopien einer Form in Reihen oder um eine Achse.</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Corner radius of the given tool.</source>
        <translation>Eckenradius des angegebenen Werkzeugs.</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cutting feed in mm/min.</source>
        <translation>Vorschub beim Fräsen in mm/min.</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>Dark stripes of the zebra, from one side of the surroundings to the other.</source>
        <translation>Dunkle Streifen des Zebras, von einer Seite der Umgebung zur anderen.</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>Deform</source>
        <translation>Verformen</translation>
    </message>
    <message>
        <source>degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>degree elevate</source>
        <translation>Grad erhöhen</translation>
    </message>
    <message>
        <source>Degree of a B-spline of shapes: so many shapes and one more act at a time. 0: one less than the number of shapes, the Bezier morph, in which all act.</source>
        <translation>Grad eines B-Splines von Formen: So viele Formen und eine mehr wirken zugleich. 0: einer weniger als Formen, der Bézier-Morph, in dem alle wirken.</translation>
    </message>
    <message>
        <source>Degree of the curve, or of the surface from line to line.</source>
        <translation>Grad der Kurve oder der Fläche von Zeile zu Zeile.</translation>
    </message>
    <message>
        <source>Degree of the surface along a line.</source>
        <translation>Grad der Fläche entlang einer Zeile.</translation>
    </message>
    <message>
        <source>degree u</source>
        <translation>Grad in u</translation>
    </message>
    <message>
        <source>degree v</source>
        <translation>Grad in v</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth by which it melts; of the ball.</source>
        <translation>Tiefe, um die er schmilzt; die der Kugel.</translation>
    </message>
    <message>
        <source>Depth of the pocket in the part; 0: as in the program&apos;s head.</source>
        <translation>Tiefe der Tasche im Teil; 0: wie im Kopf des Programms.</translation>
    </message>
    <message>
        <source>Depth of the pocket; unused when its floor is picked.</source>
        <translation>Tiefe der Tasche; unbenutzt, wenn ihr Boden gewählt ist.</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Diameter of the end mill.</source>
        <translation>Durchmesser des Fräsers.</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of its z axis.</source>
        <translation>Richtung seiner z-Achse.</translation>
    </message>
    <message>
        <source>Direction of the axis of a circular pattern.</source>
        <translation>Richtung der Achse eines kreisförmigen Musters.</translation>
    </message>
    <message>
        <source>Direction of the axis.</source>
        <translation>Richtung der Achse.</translation>
    </message>
    <message>
        <source>Direction of the axis; it lies beside the outline.</source>
        <translation>Richtung der Achse; sie liegt neben dem Umriss.</translation>
    </message>
    <message>
        <source>Direction of view; auto means top for planar drawings and iso for the rest.</source>
        <translation>Blickrichtung; automatisch heißt oben bei ebenen Zeichnungen und isometrisch sonst.</translation>
    </message>
    <message>
        <source>Direction that the x axis of the section points to at the start; 0,0,0: up, or along x where the curve starts upward.</source>
        <translation>Richtung, in die die x-Achse des Querschnitts am Anfang zeigt; 0,0,0: nach oben, oder entlang x, wo die Kurve aufwärts beginnt.</translation>
    </message>
    <message>
        <source>Direction; 0,0,0: perpendicular to the outline.</source>
        <translation>Richtung; 0,0,0: senkrecht zum Umriss.</translation>
    </message>
    <message>
        <source>Directions in which each control shape acts, first to last; from equal to to, or a whole turn: all around.</source>
        <translation>Richtungen, in denen jede Kontrollform wirkt, von der ersten zur letzten; „von“ gleich „bis“ oder eine volle Drehung: rundum.</translation>
    </message>
    <message>
        <source>Displacement of each control shape from its drawn position, first to last; others stay.</source>
        <translation>Verschiebung jeder Kontrollform von der gezeichneten Stelle, von der ersten bis zur letzten; andere bleiben.</translation>
    </message>
    <message>
        <source>display</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance between passes: a share of the diameter (45%) or a length.</source>
        <translation>Abstand der Bahnen: ein Anteil des Durchmessers (45%) oder eine Länge.</translation>
    </message>
    <message>
        <source>Distance by which it grows; of the ball.</source>
        <translation>Abstand, um den er wächst; der der Kugel.</translation>
    </message>
    <message>
        <source>Distance by which the stock exceeds the part.</source>
        <translation>Abstand, um den das Rohteil über das Teil hinausgeht.</translation>
    </message>
    <message>
        <source>Distance from one copy to the next in a row.</source>
        <translation>Abstand von einer Kopie zur nächsten in einer Reihe.</translation>
    </message>
    <message>
        <source>Distance from one row to the next.</source>
        <translation>Abstand von einer Reihe zur nächsten.</translation>
    </message>
    <message>
        <source>Distance from the centre.</source>
        <translation>Abstand vom Mittelpunkt.</translation>
    </message>
    <message>
        <source>Distance from the outline; several distances make curves, each on a layer of its own.</source>
        <translation>Abstand vom Umriss; mehrere Abstände machen Kurven, jede auf einer eigenen Ebene.</translation>
    </message>
    <message>
        <source>Distance of B-spline faces from the limit surface near extraordinary points; elsewhere they are exact.</source>
        <translation>Abstand der B-Spline-Seiten von der Grenzfläche nahe außerordentlichen Punkten; sonst sind sie exakt.</translation>
    </message>
    <message>
        <source>Distance of sections that are all drawn in one plane.</source>
        <translation>Abstand von Querschnitten, die alle in einer Ebene gezeichnet sind.</translation>
    </message>
    <message>
        <source>Distance of the corners between them.</source>
        <translation>Abstand der Ecken dazwischen.</translation>
    </message>
    <message>
        <source>Distance of the points from the centre.</source>
        <translation>Abstand der Spitzen vom Mittelpunkt.</translation>
    </message>
    <message>
        <source>Distance of the second outline above the first.</source>
        <translation>Abstand des zweiten Umrisses über dem ersten.</translation>
    </message>
    <message>
        <source>Distance of the surface from the centre.</source>
        <translation>Abstand der Oberfläche vom Mittelpunkt.</translation>
    </message>
    <message>
        <source>Distance of the tube&apos;s middle from the axis.</source>
        <translation>Abstand der Rohrmitte von der Achse.</translation>
    </message>
    <message>
        <source>Divide by the count: the result lies between the shape and its convex hull, the nearer to the hull the more copies there are.</source>
        <translation>Durch die Anzahl geteilt: Das Ergebnis liegt zwischen der Form und ihrer konvexen Hülle, umso näher an der Hülle, je mehr Kopien es sind.</translation>
    </message>
    <message>
        <source>Draw the feature edges.</source>
        <translation>Zeichnet die Formkanten.</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Duration of an animation in seconds; it repeats endlessly.</source>
        <translation>Dauer einer Animation in Sekunden; sie wiederholt sich endlos.</translation>
    </message>
    <message>
        <source>Duration of the film in seconds.</source>
        <translation>Dauer des Films in Sekunden.</translation>
    </message>
    <message>
        <source>ease</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>ease-in</source>
        <translation>weich beginnend</translation>
    </message>
    <message>
        <source>ease-out</source>
        <translation>weich endend</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edges of the path that the section follows, in any order: of a solid, or of a drawing with several curves.</source>
        <translation>Kanten des Weges, denen der Querschnitt folgt, in beliebiger Reihenfolge: eines Körpers oder einer Zeichnung mit mehreren Kurven.</translation>
    </message>
    <message>
        <source>edits</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Elevate the degree by one; the morph stays the same when all shapes are convex.</source>
        <translation>Erhöht den Grad um eins; der Morph bleibt derselbe, wenn alle Formen konvex sind.</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>Even: the frames are spread evenly from 0 to 1; lengths: each sequence keeps its share of the time.</source>
        <translation>Gleichmäßig: Die Bilder sind gleichmäßig von 0 bis 1 verteilt; Längen: Jede Folge behält ihren Anteil an der Zeit.</translation>
    </message>
    <message>
        <source>evenly from 0 to 1</source>
        <translation>gleichmäßig von 0 bis 1</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>explicit</source>
        <translation>explizit</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extrudieren</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>face is</source>
        <translation>Seite ist</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Faces this close count as touching; 0: only faces that do touch.</source>
        <translation>So nahe Seiten gelten als berührend; 0: nur solche, die sich berühren.</translation>
    </message>
    <message>
        <source>Factor of each shape about the origin, first to last; a negative one reflects in the origin, 0 leaves the shape out. Others are 1.</source>
        <translation>Faktor jeder Form um den Ursprung, von der ersten zur letzten; ein negativer spiegelt am Ursprung, 0 lässt die Form weg. Andere sind 1.</translation>
    </message>
    <message>
        <source>Factor on the distance from letter to letter.</source>
        <translation>Faktor für den Abstand von Buchstabe zu Buchstabe.</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>factors</source>
        <translation>Faktoren</translation>
    </message>
    <message>
        <source>Factors along x, y and z on top of the scale, before it is turned.</source>
        <translation>Faktoren in x, y und z zusätzlich zum Maßstab, vor der Drehung.</translation>
    </message>
    <message>
        <source>Family of an installed font.</source>
        <translation>Familie einer installierten Schrift.</translation>
    </message>
    <message>
        <source>fanuc</source>
        <translation>Fanuc</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Fill closed outlines and make solids; off: sheets over the curves.</source>
        <translation>Füllt geschlossene Umrisse und macht Körper; aus: Flächen über den Kurven.</translation>
    </message>
    <message>
        <source>Fillet</source>
        <translation>Verrundung</translation>
    </message>
    <message>
        <source>Fineness of the ball: 20 faces, with each subdivision four times as many.</source>
        <translation>Feinheit der Kugel: 20 Seiten, mit jeder Unterteilung viermal so viele.</translation>
    </message>
    <message>
        <source>Fineness: 20 faces, with each subdivision four times as many.</source>
        <translation>Feinheit: 20 Seiten, mit jeder Unterteilung viermal so viele.</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Schlichtaufmaß</translation>
    </message>
    <message>
        <source>First direction of the sector, counter-clockwise from +x.</source>
        <translation>Erste Richtung des Sektors, gegen den Uhrzeigersinn ab +x.</translation>
    </message>
    <message>
        <source>First half-axis.</source>
        <translation>Erste Halbachse.</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>Zähligkeit</translation>
    </message>
    <message>
        <source>following</source>
        <translation>danach</translation>
    </message>
    <message>
        <source>font</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>four-point</source>
        <translation>Vierpunkt</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Einzelbild</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame of the sequence, counted from 1.</source>
        <translation>Bild der Sequenz, ab 1 gezählt.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Frames at which t is given, and how it goes on from there.</source>
        <translation>Bilder, bei denen t gegeben ist, und wie es von dort weitergeht.</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>From end to end.</source>
        <translation>Von Ende zu Ende.</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorne</translation>
    </message>
    <message>
        <source>fuzzy</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>G54</source>
        <translation>G54</translation>
    </message>
    <message>
        <source>G55</source>
        <translation>G55</translation>
    </message>
    <message>
        <source>G56</source>
        <translation>G56</translation>
    </message>
    <message>
        <source>G57</source>
        <translation>G57</translation>
    </message>
    <message>
        <source>G58</source>
        <translation>G58</translation>
    </message>
    <message>
        <source>G59</source>
        <translation>G59</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>gaußsche Krümmung</translation>
    </message>
    <message>
        <source>gcode</source>
        <translation>G-Code</translation>
    </message>
    <message>
        <source>grbl</source>
        <translation>GRBL</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Growth of the share of later solids with t.</source>
        <translation>Wie der Anteil späterer Körper mit t wächst.</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height above the material at which rapids down end.</source>
        <translation>Höhe über dem Material, in der Eilgänge abwärts enden.</translation>
    </message>
    <message>
        <source>Height above the stock and the whole solid at which the tool crosses.</source>
        <translation>Höhe über Rohteil und ganzem Körper, in der das Werkzeug quer fährt.</translation>
    </message>
    <message>
        <source>Height along the direction; below 0: in the opposite direction.</source>
        <translation>Höhe in der Richtung; unter 0: in der Gegenrichtung.</translation>
    </message>
    <message>
        <source>Height of a capital H.</source>
        <translation>Höhe eines großen H.</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>helicoid</source>
        <translation>Wendelfläche</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>Helix</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>how</source>
        <translation>wie</translation>
    </message>
    <message>
        <source>How far a tube bends or a sheet arches.</source>
        <translation>Wie weit sich ein Rohr biegt oder eine Bogenfläche wölbt.</translation>
    </message>
    <message>
        <source>How far it is moved, or where it is placed.</source>
        <translation>Wie weit er verschoben oder wohin er gesetzt wird.</translation>
    </message>
    <message>
        <source>How files of the format Control points (text) are read.</source>
        <translation>Wie Dateien des Formats Kontrollpunkte (Text) gelesen werden.</translation>
    </message>
    <message>
        <source>How files of the format G-code (LinuxCNC, GRBL) are read.</source>
        <translation>Wie Dateien des Formats G-Code (LinuxCNC, GRBL) gelesen werden.</translation>
    </message>
    <message>
        <source>How files of the format Two-parameter motion (JSON) are read.</source>
        <translation>Wie Dateien des Formats Bewegung in zwei Parametern (JSON) gelesen werden.</translation>
    </message>
    <message>
        <source>How it gets going: in begins slowly (s^2), out ends slowly, in-out does both (smoothstep, 3 s^2 - 2 s^3).</source>
        <translation>Wie sie in Gang kommt: „Anfang“ beginnt langsam (s^2), „Ende“ endet langsam, „beides“ tut beides (Smoothstep, 3 s^2 - 2 s^3).</translation>
    </message>
    <message>
        <source>How it goes on to the next key: in begins slowly, out ends slowly, hold stays.</source>
        <translation>Wie es zum nächsten Schlüssel weitergeht: in beginnt langsam, out endet langsam, hold bleibt.</translation>
    </message>
    <message>
        <source>How many copies are added.</source>
        <translation>Wie viele Kopien addiert werden.</translation>
    </message>
    <message>
        <source>How many in-betweens of each way are in the picture, from t = 0 to 1.</source>
        <translation>Wie viele Zwischenformen jedes Verfahrens im Bild sind, von t = 0 bis 1.</translation>
    </message>
    <message>
        <source>How many times as large each control shape is as drawn, about its centre, first to last; others stay.</source>
        <translation>Wievielmal so groß jede Kontrollform ist wie gezeichnet, um ihre Mitte, von der ersten zur letzten; andere bleiben.</translation>
    </message>
    <message>
        <source>How many times the pull is repeated around the motion.</source>
        <translation>Wie oft der Zug um die Bewegung herum wiederholt wird.</translation>
    </message>
    <message>
        <source>How many times the twist is repeated around the motion.</source>
        <translation>Wie oft die Verdrehung um die Bewegung herum wiederholt wird.</translation>
    </message>
    <message>
        <source>How the in-betweens are computed; the shape is the same. Automatic chooses the fewest sums, and explicit for more than four shapes; convex requires convex control shapes between the ends.</source>
        <translation>Wie die Zwischenformen berechnet werden; die Form ist dieselbe. Automatisch wählt die wenigsten Summen, bei mehr als vier Formen explizit; konvex verlangt konvexe Kontrollformen zwischen den Enden.</translation>
    </message>
    <message>
        <source>How the tool gets down into the material.</source>
        <translation>Wie das Werkzeug in das Material kommt.</translation>
    </message>
    <message>
        <source>How wide a part changes: 0 the spans of the motion, above it finer ones, below it coarser ones.</source>
        <translation>Wie breit ein Teil sich ändert: 0 die Abschnitte der Bewegung, darüber feinere, darunter gröbere.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>in</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>In place of the number: the frame whose time is nearest to this; of two the earlier one.</source>
        <translation>Statt der Nummer: das Bild, dessen Zeit dieser am nächsten ist; von zweien das frühere.</translation>
    </message>
    <message>
        <source>in-out</source>
        <translation>beides</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Inflate</source>
        <translation>Aufblasen</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>inscribed</source>
        <translation>einbeschrieben</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Inward inclination of the sides; below 0: outward.</source>
        <translation>Neigung der Seiten nach innen; unter 0: nach außen.</translation>
    </message>
    <message>
        <source>iso</source>
        <translation>iso</translation>
    </message>
    <message>
        <source>iso curves</source>
        <translation>Iso-Kurven</translation>
    </message>
    <message>
        <source>Iso-curves in each direction of a face.</source>
        <translation>Iso-Kurven in jeder Richtung einer Seite.</translation>
    </message>
    <message>
        <source>italic</source>
        <translation>kursiv</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>Its new weight, above 0; the pole stays in place.</source>
        <translation>Sein neues Gewicht, über 0; der Pol bleibt an seinem Ort.</translation>
    </message>
    <message>
        <source>Its position.</source>
        <translation>Seine Position.</translation>
    </message>
    <message>
        <source>join</source>
        <translation>vereinigen</translation>
    </message>
    <message>
        <source>Join faces on the same surface and edges on the same curve.</source>
        <translation>Verbindet Seiten auf derselben Fläche und Kanten auf derselben Kurve.</translation>
    </message>
    <message>
        <source>Join sequences</source>
        <translation>Folgen verbinden</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>keep degenerate</source>
        <translation>Platz ohne Breite behalten</translation>
    </message>
    <message>
        <source>Keep room without width, where the shape just fits: curves and points, which make the result a drawing.</source>
        <translation>Platz ohne Breite behalten, wo die Form gerade hineinpasst: Kurven und Punkte, die das Ergebnis zu einer Zeichnung machen.</translation>
    </message>
    <message>
        <source>Keep the original beside its image.</source>
        <translation>Behält das Original neben seinem Bild.</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>knots</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Knots of the B-spline, as many as shapes and the degree and one more, the first and last as often as the degree and once more. None: evenly spaced.</source>
        <translation>Knoten des B-Splines, so viele wie Formen und der Grad und einer mehr, der erste und der letzte so oft wie der Grad und einmal mehr. Keine: gleichmäßig verteilt.</translation>
    </message>
    <message>
        <source>Knots to insert in u; one that is repeated lets a pull crease.</source>
        <translation>Knoten, die in u eingefügt werden; ein wiederholter erlaubt einem Zug einen Knick.</translation>
    </message>
    <message>
        <source>Knots to insert in v.</source>
        <translation>Knoten, die in v eingefügt werden.</translation>
    </message>
    <message>
        <source>lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größte Krümmung</translation>
    </message>
    <message>
        <source>Largest depth of one step; all steps are equal. 0: half the diameter.</source>
        <translation>Größte Tiefe eines Schritts; alle Schritte sind gleich. 0: der halbe Durchmesser.</translation>
    </message>
    <message>
        <source>Largest deviation of the cubic surface, measured at equal parameters.</source>
        <translation>Größte Abweichung der kubischen Fläche, gemessen bei gleichen Parametern.</translation>
    </message>
    <message>
        <source>Largest deviation of the path.</source>
        <translation>Größte Abweichung des Weges.</translation>
    </message>
    <message>
        <source>Largest distance between a curve and the cubic pieces that stand for it; places are kept to 0.002 mm.</source>
        <translation>Größter Abstand zwischen einer Kurve und den kubischen Stücken, die für sie stehen; Lagen werden auf 0,002 mm gehalten.</translation>
    </message>
    <message>
        <source>Largest distance between a curved shape and its polygons; 0: a thousandth of its size.</source>
        <translation>Größter Abstand zwischen einer krummen Form und ihren Vielecken; 0: ein Tausendstel ihrer Größe.</translation>
    </message>
    <message>
        <source>Largest distance between a curved solid or curve and the polyhedron made of it.</source>
        <translation>Größter Abstand zwischen einem krummen Körper oder einer Kurve und dem Polyeder daraus.</translation>
    </message>
    <message>
        <source>Largest distance between a spline and the cubic pieces that stand for it.</source>
        <translation>Größter Abstand zwischen einem Spline und den kubischen Stücken, die für ihn stehen.</translation>
    </message>
    <message>
        <source>Largest distance between curves and the polygons that stand for them.</source>
        <translation>Größter Abstand zwischen Kurven und den Polygonen, die für sie stehen.</translation>
    </message>
    <message>
        <source>Largest distance between curves and the polygons that stand for them, and by which more than two terms may fill dents.</source>
        <translation>Größter Abstand zwischen Kurven und den Polygonen, die für sie stehen, und um den mehr als zwei Terme Dellen füllen dürfen.</translation>
    </message>
    <message>
        <source>Largest distance between curves and the polygons that stand for them. Once the convex hull is within it, the hull is the result.</source>
        <translation>Größter Abstand zwischen Kurven und den Polygonen, die für sie stehen. Sobald die konvexe Hülle darin liegt, ist sie das Ergebnis.</translation>
    </message>
    <message>
        <source>Largest distance between free-form curves and the splines that stand for them.</source>
        <translation>Größter Abstand zwischen Freiformkurven und den Splines, die für sie stehen.</translation>
    </message>
    <message>
        <source>Largest distance between the shape and its picture; 0 is as fine as the picture needs.</source>
        <translation>Größter Abstand zwischen der Form und ihrem Bild; 0 ist so fein, wie das Bild es braucht.</translation>
    </message>
    <message>
        <source>Largest distance from the true tube, measured at equal parameters.</source>
        <translation>Größter Abstand vom wahren Rohr, gemessen bei gleichen Parametern.</translation>
    </message>
    <message>
        <source>Largest error of the axis; lower bumps of a smooth outline have no branch.</source>
        <translation>Größter Fehler der Achse; flachere Buckel eines glatten Umrisses haben keinen Ast.</translation>
    </message>
    <message>
        <source>Largest error of the distance.</source>
        <translation>Größter Fehler des Abstands.</translation>
    </message>
    <message>
        <source>Largest number of searches for closest points.</source>
        <translation>Größte Zahl der Suchen nach nächsten Punkten.</translation>
    </message>
    <message>
        <source>Last direction.</source>
        <translation>Letzte Richtung.</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>leave floor</source>
        <translation>Aufmaß Boden</translation>
    </message>
    <message>
        <source>Leave out the first frame of each sequence that comes after another part, as it repeats the end of that.</source>
        <translation>Lässt das erste Bild jeder Folge nach einem anderen Teil weg, da es dessen Ende wiederholt.</translation>
    </message>
    <message>
        <source>Leave the background out.</source>
        <translation>Lässt den Hintergrund weg.</translation>
    </message>
    <message>
        <source>leave wall</source>
        <translation>Aufmaß Wand</translation>
    </message>
    <message>
        <source>Leaves out lines that do not close, with a warning, instead of refusing them.</source>
        <translation>Lässt Linien, die sich nicht schließen, mit einer Warnung aus, statt sie abzulehnen.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>left-out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length along its axis.</source>
        <translation>Länge entlang seiner Achse.</translation>
    </message>
    <message>
        <source>Length along its x axis.</source>
        <translation>Länge entlang seiner x-Achse.</translation>
    </message>
    <message>
        <source>Length along its y axis.</source>
        <translation>Länge entlang seiner y-Achse.</translation>
    </message>
    <message>
        <source>Length along the axis.</source>
        <translation>Länge entlang der Achse.</translation>
    </message>
    <message>
        <source>Length along the axis; of a plane, along y.</source>
        <translation>Länge entlang der Achse; bei einer Ebene in y.</translation>
    </message>
    <message>
        <source>Length of a plane along x.</source>
        <translation>Länge einer Ebene in x.</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Less than a full turn leaves a bend.</source>
        <translation>Weniger als eine volle Drehung lässt einen Bogen übrig.</translation>
    </message>
    <message>
        <source>Less than a full turn leaves a wedge.</source>
        <translation>Weniger als eine volle Drehung lässt einen Keil übrig.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenzform</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>line numbers</source>
        <translation>Zeilennummern</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>linuxcnc</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Literal</source>
        <translation>Kurzform</translation>
    </message>
    <message>
        <source>Loft</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Loop</translation>
    </message>
    <message>
        <source>mach3</source>
        <translation>Mach3</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>mittlere Krümmung</translation>
    </message>
    <message>
        <source>Medial axis</source>
        <translation>Mittelachse</translation>
    </message>
    <message>
        <source>Melt</source>
        <translation>Abschmelzen</translation>
    </message>
    <message>
        <source>merge ends</source>
        <translation>Enden verschmelzen</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Meshes: Catmull-Clark for any polygons, Loop for triangles. Polygons: cubic or quadratic B-splines, or four-point, which passes through the points.</source>
        <translation>Netze: Catmull-Clark für beliebige Vielecke, Loop für Dreiecke. Polygone: kubische oder quadratische B-Splines oder Vierpunkt, das durch die Punkte geht.</translation>
    </message>
    <message>
        <source>Minkowski</source>
        <translation>Minkowski</translation>
    </message>
    <message>
        <source>Minkowski difference</source>
        <translation>Minkowski-Differenz</translation>
    </message>
    <message>
        <source>Minkowski sum</source>
        <translation>Minkowski-Summe</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>spiegeln</translation>
    </message>
    <message>
        <source>mitred</source>
        <translation>auf Gehrung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Modeling</source>
        <translation>Modellieren</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Morph</translation>
    </message>
    <message>
        <source>Morph as solid</source>
        <translation>Morph als Körper</translation>
    </message>
    <message>
        <source>Morphology</source>
        <translation>Morphologie</translation>
    </message>
    <message>
        <source>Morphs compared</source>
        <translation>Morphs im Vergleich</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>move</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Moved by the vector, or placed at it.</source>
        <translation>Um den Vektor verschoben oder an ihn gesetzt.</translation>
    </message>
    <message>
        <source>Multiplied by the factors, or set to them.</source>
        <translation>Mit den Faktoren multipliziert oder auf sie gesetzt.</translation>
    </message>
    <message>
        <source>multiply</source>
        <translation>multiplizieren</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normal of the mirror plane.</source>
        <translation>Normale der Spiegelebene.</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normiert</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Number of copies in a row, including the original.</source>
        <translation>Zahl der Kopien in einer Reihe, mit dem Original.</translation>
    </message>
    <message>
        <source>Number of frames of a sequence, each with the three ways side by side; 0 makes one picture with a row for each way and their areas over t.</source>
        <translation>Anzahl der Bilder einer Folge, jedes mit den drei Verfahren nebeneinander; 0 ergibt ein Bild mit einer Zeile je Verfahren und ihren Flächen über t.</translation>
    </message>
    <message>
        <source>Number of frames, at even times, each the nearest one there is: none is computed anew. 0 keeps the frames and moves their times.</source>
        <translation>Zahl der Bilder zu gleichmäßigen Zeiten, jedes das nächste vorhandene: Keines wird neu berechnet. 0 behält die Bilder und verschiebt ihre Zeiten.</translation>
    </message>
    <message>
        <source>Number of points along drawn targets.</source>
        <translation>Zahl der Punkte entlang gezeichneter Ziele.</translation>
    </message>
    <message>
        <source>Number of points.</source>
        <translation>Zahl der Spitzen.</translation>
    </message>
    <message>
        <source>Number of refinements; each multiplies the faces by four.</source>
        <translation>Zahl der Verfeinerungen; jede vervierfacht die Seiten.</translation>
    </message>
    <message>
        <source>Number of rows.</source>
        <translation>Zahl der Reihen.</translation>
    </message>
    <message>
        <source>Number of shapes of a sequence from 0 to 1; 0 makes the one at t.</source>
        <translation>Zahl der Formen einer Folge von 0 bis 1; 0 macht nur die bei t.</translation>
    </message>
    <message>
        <source>Number of sides.</source>
        <translation>Zahl der Seiten.</translation>
    </message>
    <message>
        <source>Number of solids of a sequence from 0 to 1; 0 makes the one at t.</source>
        <translation>Zahl der Körper einer Folge von 0 bis 1; 0 macht nur den bei t.</translation>
    </message>
    <message>
        <source>Number of solids of a sequence from size 0 to the whole size; 0 makes only the last one.</source>
        <translation>Zahl der Körper einer Folge von Größe 0 bis zur ganzen Größe; 0 macht nur den letzten.</translation>
    </message>
    <message>
        <source>Number the lines N10, N20, ..</source>
        <translation>Nummeriert die Zeilen N10, N20, ..</translation>
    </message>
    <message>
        <source>Of a mesh: cells in each direction of every span of the control net.</source>
        <translation>Bei einem Netz: Zellen in jeder Richtung jedes Abschnitts des Kontrollnetzes.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Parallele</translation>
    </message>
    <message>
        <source>offsets</source>
        <translation>Verschiebungen</translation>
    </message>
    <message>
        <source>One number for each control shape after the first, instead of t; all equal, they are t.</source>
        <translation>Eine Zahl für jede Kontrollform nach der ersten, statt t; alle gleich bedeuten sie t.</translation>
    </message>
    <message>
        <source>One shape out of a sequence.</source>
        <translation>Eine Form aus einer Folge.</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opening of an outline</source>
        <translation>Öffnen eines Umrisses</translation>
    </message>
    <message>
        <source>operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>out</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Outlines at even distances from the outlines of a part.</source>
        <translation>Umrisse in gleichmäßigen Abständen von den Umrissen eines Teils.</translation>
    </message>
    <message>
        <source>Outlines in their order.</source>
        <translation>Umrisse in ihrer Reihenfolge.</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Parameter along it.</source>
        <translation>Parameter an ihr entlang.</translation>
    </message>
    <message>
        <source>Parameter around the surface.</source>
        <translation>Parameter um die Fläche herum.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Part of the way, from 0 (before the edits) to 1 (after the last one).</source>
        <translation>Teil des Weges, von 0 (vor den Änderungen) bis 1 (nach der letzten).</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Pictures per second.</source>
        <translation>Bilder pro Sekunde.</translation>
    </message>
    <message>
        <source>pins</source>
        <translation>Nadeln</translation>
    </message>
    <message>
        <source>Pipe</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>place</source>
        <translation>ansetzen</translation>
    </message>
    <message>
        <source>Place in the tool changer.</source>
        <translation>Platz im Werkzeugwechsler.</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Places after the point, in inches one more; for Fanuc at most 3.</source>
        <translation>Stellen nach dem Punkt, in Zoll eine mehr; für Fanuc höchstens 3.</translation>
    </message>
    <message>
        <source>Places on the surface and their targets.</source>
        <translation>Stellen auf der Fläche und ihre Ziele.</translation>
    </message>
    <message>
        <source>Places on the surface at which the frame turns.</source>
        <translation>Stellen auf der Fläche, an denen sich das Bezugssystem dreht.</translation>
    </message>
    <message>
        <source>Places that stay as they are.</source>
        <translation>Stellen, die bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Places that stay where they are.</source>
        <translation>Stellen, die bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>schlicht</translation>
    </message>
    <message>
        <source>Plain motion</source>
        <translation>Einfache Bewegung</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Play it backwards.</source>
        <translation>Spielt sie rückwärts.</translation>
    </message>
    <message>
        <source>plunge</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Plunge feed in mm/min.</source>
        <translation>Vorschub beim Eintauchen in mm/min.</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>Tasche</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points of blossom numbers that the morph runs through, as long from each to the next. None: t alone.</source>
        <translation>Punkte aus Blossom-Zahlen, durch die der Morph läuft, von jedem zum nächsten gleich lange. Keine: t allein.</translation>
    </message>
    <message>
        <source>pole</source>
        <translation>Pol</translation>
    </message>
    <message>
        <source>Pole of the trajectory, counted from 0.</source>
        <translation>Pol der Bahn, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>Poles of the orientation that are turned, or set.</source>
        <translation>Pole der Orientierung, die gedreht oder gesetzt werden.</translation>
    </message>
    <message>
        <source>Poles of the scaling that are multiplied, or set.</source>
        <translation>Pole der Skalierung, die multipliziert oder gesetzt werden.</translation>
    </message>
    <message>
        <source>Poles of the trajectory that are moved or placed.</source>
        <translation>Pole der Bahn, die verschoben oder gesetzt werden.</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position along the morph, from 0 (the first shape) to 1 (the last); beyond them it goes on as far as there are shapes that lead through both.</source>
        <translation>Stelle im Morph, von 0 (die erste Form) bis 1 (die letzte); darüber hinaus geht er weiter, soweit es Formen gibt, die durch beide führen.</translation>
    </message>
    <message>
        <source>Position along the morph, from 0 (the first solid) to 1 (the last).</source>
        <translation>Stelle im Morph, von 0 (der erste Körper) bis 1 (der letzte).</translation>
    </message>
    <message>
        <source>post</source>
        <translation>Postprozessor</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>pulls</source>
        <translation>Züge</translation>
    </message>
    <message>
        <source>Put all frames of a sequence into one file that plays them, instead of a file each.</source>
        <translation>Schreibt alle Bilder einer Folge in eine Datei, die sie abspielt, statt in eine Datei je Bild.</translation>
    </message>
    <message>
        <source>Put the origin of the drawing on the start of the path, square to it; off: sweep it from where it lies.</source>
        <translation>Setzt den Ursprung der Zeichnung auf den Anfang des Pfades, senkrecht dazu; aus: führt sie von dort, wo sie liegt.</translation>
    </message>
    <message>
        <source>Put up to so many frames of a sequence, evenly spread, beside each other into one file, each with its time; 0 is a file for each frame.</source>
        <translation>Stellt bis zu so viele Bilder einer Folge, gleichmäßig verteilt, nebeneinander in eine Datei, jedes mit seiner Zeit; 0 ergibt eine Datei je Bild.</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at its height; 0 makes a point.</source>
        <translation>Radius in der Höhe; 0 macht eine Spitze.</translation>
    </message>
    <message>
        <source>Radius at its position; 0 makes a point.</source>
        <translation>Radius an der Position; 0 macht eine Spitze.</translation>
    </message>
    <message>
        <source>Radius of a cone at its top; 0 makes a point.</source>
        <translation>Radius eines Kegels an seinem oberen Ende; 0 macht eine Spitze.</translation>
    </message>
    <message>
        <source>Radius of a round section; unused with a profile.</source>
        <translation>Radius eines runden Querschnitts; unbenutzt mit einem Profil.</translation>
    </message>
    <message>
        <source>Radius of the ball.</source>
        <translation>Radius der Kugel.</translation>
    </message>
    <message>
        <source>Radius of the base.</source>
        <translation>Radius der Grundfläche.</translation>
    </message>
    <message>
        <source>Radius of the circle around it or inside it.</source>
        <translation>Radius des Um- oder Inkreises.</translation>
    </message>
    <message>
        <source>Radius of the corners; at most half of the shorter side.</source>
        <translation>Radius der Ecken; höchstens die Hälfte der kürzeren Seite.</translation>
    </message>
    <message>
        <source>Radius of the end mill&apos;s corners.</source>
        <translation>Radius der Ecken des Fräsers.</translation>
    </message>
    <message>
        <source>Radius of the rounding.</source>
        <translation>Radius der Verrundung.</translation>
    </message>
    <message>
        <source>Radius of the section of a torus or a tube.</source>
        <translation>Radius des Querschnitts von Torus oder Rohr.</translation>
    </message>
    <message>
        <source>Radius of the tube; smaller than the radius of the ring.</source>
        <translation>Radius des Rohrs; kleiner als der Radius des Rings.</translation>
    </message>
    <message>
        <source>Radius; of a torus or a tube, that of the ring or the bend.</source>
        <translation>Radius; bei Torus oder Rohr der des Rings oder der Biegung.</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>ramp angle</source>
        <translation>Rampenwinkel</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Read what the tool draws in the plane, or every move of it; auto: the moves when the program turns the spindle or names a tool and moves in z.</source>
        <translation>Liest, was das Werkzeug in der Ebene zeichnet, oder jede Bewegung; automatisch: die Bewegungen, wenn das Programm die Spindel dreht oder ein Werkzeug nennt und sich in z bewegt.</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>recursive</source>
        <translation>rekursiv</translation>
    </message>
    <message>
        <source>Refine motion</source>
        <translation>Bewegung verfeinern</translation>
    </message>
    <message>
        <source>Refinements of a limit mesh or polygon.</source>
        <translation>Verfeinerungen eines Grenznetzes oder -polygons.</translation>
    </message>
    <message>
        <source>regular</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>Repeat it mirrored, with u reversed.</source>
        <translation>Wiederholt ihn gespiegelt, mit umgekehrtem u.</translation>
    </message>
    <message>
        <source>Repeated sum</source>
        <translation>Wiederholte Summe</translation>
    </message>
    <message>
        <source>Residue narrower than this does not count; a deeper gouge is a warning.</source>
        <translation>Schmalere Reste zählen nicht; eine tiefere Verletzung ist eine Warnung.</translation>
    </message>
    <message>
        <source>Resistance of control points to being moved, larger for those with little influence; 0 means the shortest movement that fits best.</source>
        <translation>Widerstand der Kontrollpunkte gegen das Verschieben, größer bei geringem Einfluss; 0 ist die kürzeste Bewegung, die am besten passt.</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Retime sequence</source>
        <translation>Folge neu takten</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>Revolutions per minute; 0: the program does not start the spindle.</source>
        <translation>Umdrehungen pro Minute; 0: das Programm startet die Spindel nicht.</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>Rotieren</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Role of the picked face; automatic: the floor when walls rise all around it.</source>
        <translation>Rolle der gewählten Seite; automatisch: der Boden, wenn ringsum Wände aufsteigen.</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation about its axis.</source>
        <translation>Drehung um seine Achse.</translation>
    </message>
    <message>
        <source>Rotation about its centre.</source>
        <translation>Drehung um den Mittelpunkt.</translation>
    </message>
    <message>
        <source>Rotation about the axis.</source>
        <translation>Drehung um die Achse.</translation>
    </message>
    <message>
        <source>Rotation of each control shape about its centre, counter-clockwise, first to last; others stay.</source>
        <translation>Drehung jeder Kontrollform um ihre Mitte gegen den Uhrzeigersinn, von der ersten zur letzten; andere bleiben.</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>row</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Row of the pole along u, counted from 0.</source>
        <translation>Reihe des Pols in u, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>ruled</source>
        <translation>geradlinig</translation>
    </message>
    <message>
        <source>safe height</source>
        <translation>sichere Höhe</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Stichproben</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Scale factor.</source>
        <translation>Maßstabsfaktor.</translation>
    </message>
    <message>
        <source>Scale the result so that its area blends those of the shapes.</source>
        <translation>Skaliert das Ergebnis so, dass seine Fläche zwischen denen der Formen überblendet.</translation>
    </message>
    <message>
        <source>scales</source>
        <translation>Maßstäbe</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>schema</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>Schema</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweite Breite</translation>
    </message>
    <message>
        <source>second count</source>
        <translation>zweite Anzahl</translation>
    </message>
    <message>
        <source>Second half-axis.</source>
        <translation>Zweite Halbachse.</translation>
    </message>
    <message>
        <source>second step</source>
        <translation>zweiter Abstand</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>Querschnitte</translation>
    </message>
    <message>
        <source>sectors</source>
        <translation>Sektoren</translation>
    </message>
    <message>
        <source>segments</source>
        <translation>Segmente</translation>
    </message>
    <message>
        <source>sequence</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Sequences and single shapes, one after the other.</source>
        <translation>Folgen und einzelne Formen, eine nach der anderen.</translation>
    </message>
    <message>
        <source>Sequences, and single shapes, each of which is one frame.</source>
        <translation>Folgen und einzelne Formen, von denen jede ein Bild ist.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>setzen</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Share of the angle left, seen from the trajectory, by which the frame turns.</source>
        <translation>Anteil des übrigen Winkels, von der Bahn aus gesehen, um den sich das Bezugssystem dreht.</translation>
    </message>
    <message>
        <source>Share of the way left that scaling goes. The last of the three above 0 counts as 1.</source>
        <translation>Anteil des übrigen Weges, den die Skalierung geht. Der letzte der drei über 0 zählt als 1.</translation>
    </message>
    <message>
        <source>Share of the way that the trajectory goes; sections at that height go with it.</source>
        <translation>Anteil des Weges, den die Bahn geht; Querschnitte in dieser Höhe gehen mit.</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>Bogenfläche</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>Schale</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Side of the offset; both makes the band along the outline.</source>
        <translation>Seite der Parallele; beide macht das Band entlang des Umrisses.</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>simplify</source>
        <translation>vereinfachen</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Single points of the limit shape and their targets.</source>
        <translation>Einzelne Punkte der Grenzform und ihre Ziele.</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>skip open</source>
        <translation>offene auslassen</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Langloch</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Solid difference</source>
        <translation>Körperdifferenz</translation>
    </message>
    <message>
        <source>Solid morph</source>
        <translation>Körpermorph</translation>
    </message>
    <message>
        <source>Solid sum</source>
        <translation>Körpersumme</translation>
    </message>
    <message>
        <source>Solids or regions united, cut from each other or intersected.</source>
        <translation>Körper oder Flächen, vereinigt, voneinander abgezogen oder geschnitten.</translation>
    </message>
    <message>
        <source>Solids, or regions. A difference is the first without the others.</source>
        <translation>Körper oder Flächen. Eine Differenz ist die erste Form ohne die anderen.</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Spans of the control net along, at least.</source>
        <translation>Abschnitte des Kontrollnetzes der Länge nach, mindestens.</translation>
    </message>
    <message>
        <source>Spans of the control net around; more of them let pulls be narrower.</source>
        <translation>Abschnitte des Kontrollnetzes ringsum; mehr davon erlauben schmalere Züge.</translation>
    </message>
    <message>
        <source>Spans of the control net in u; at least 4 around. More of them let pulls be narrower.</source>
        <translation>Abschnitte des Kontrollnetzes in u; ringsum mindestens 4. Mehr davon erlauben schmalere Züge.</translation>
    </message>
    <message>
        <source>Spans of the control net in v.</source>
        <translation>Abschnitte des Kontrollnetzes in v.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>Stern</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>stepdown</source>
        <translation>Tiefenzustellung</translation>
    </message>
    <message>
        <source>stepover</source>
        <translation>seitliche Zustellung</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>stock margin</source>
        <translation>Rohteilzugabe</translation>
    </message>
    <message>
        <source>Stock that the passes leave on the walls for a last pass at full depth; 0: no such pass.</source>
        <translation>Aufmaß, das die Bahnen an den Wänden für eine letzte Bahn in voller Tiefe lassen; 0: keine solche Bahn.</translation>
    </message>
    <message>
        <source>stock thickness</source>
        <translation>Rohteildicke</translation>
    </message>
    <message>
        <source>Stock to leave on the floor.</source>
        <translation>Aufmaß, das am Boden bleibt.</translation>
    </message>
    <message>
        <source>Stock to leave on the walls.</source>
        <translation>Aufmaß, das an den Wänden bleibt.</translation>
    </message>
    <message>
        <source>Stock to leave on the walls; 0: as in the program&apos;s head.</source>
        <translation>Aufmaß, das an den Wänden bleibt; 0: wie im Kopf des Programms.</translation>
    </message>
    <message>
        <source>Straight from one section to the next instead of smooth through all.</source>
        <translation>Gerade von einem Querschnitt zum nächsten statt glatt durch alle.</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>Streckung</translation>
    </message>
    <message>
        <source>stripe angle</source>
        <translation>Winkel der Streifen</translation>
    </message>
    <message>
        <source>stripes</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>style</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Subdivide</source>
        <translation>Unterteilen</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Unterteilung</translation>
    </message>
    <message>
        <source>subdivisions</source>
        <translation>Unterteilungen</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Sweep</translation>
    </message>
    <message>
        <source>Sweep along</source>
        <translation>Sweep entlang</translation>
    </message>
    <message>
        <source>Sweep along an outline</source>
        <translation>Entlang eines Umrisses ziehen</translation>
    </message>
    <message>
        <source>Sweeps a program&apos;s tool along its moves and measures gouge and residue.</source>
        <translation>Führt das Werkzeug eines Programms auf dessen Wegen und misst, was verletzt wird und was stehen bleibt.</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>t of that frame.</source>
        <translation>t dieses Bildes.</translation>
    </message>
    <message>
        <source>tangent</source>
        <translation>tangential</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>Schräge</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Target stroke</source>
        <translation>Zielstrich</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>The angle that the copies divide.</source>
        <translation>Der Winkel, den sich die Kopien teilen.</translation>
    </message>
    <message>
        <source>The area that a shape covers while its origin runs along the boundary of another.</source>
        <translation>Die Fläche, die eine Form überstreicht, während ihr Ursprung am Rand einer anderen entlangläuft.</translation>
    </message>
    <message>
        <source>The area that one shape covers while its origin moves over the other.</source>
        <translation>Die Fläche, die eine Form überdeckt, während ihr Ursprung über die andere wandert.</translation>
    </message>
    <message>
        <source>The Boolean operation.</source>
        <translation>Die boolesche Operation.</translation>
    </message>
    <message>
        <source>The cage itself; limit: a mesh or polygon with its vertices on the limit shape; faces: B-spline faces, or the B-spline curve. By default the command line uses limit for STL, PLY and OFF and faces for STEP, IGES and BREP.</source>
        <translation>Der Käfig selbst; Grenzform: ein Netz oder Polygon mit Ecken auf der Grenzform; Seiten: B-Spline-Seiten oder die B-Spline-Kurve. Die Befehlszeile nimmt von sich aus die Grenzform für STL, PLY und OFF und Seiten für STEP, IGES und BREP.</translation>
    </message>
    <message>
        <source>The centre, in the plane z = 0.</source>
        <translation>Der Mittelpunkt, in der Ebene z = 0.</translation>
    </message>
    <message>
        <source>The centres of the largest discs that a part holds.</source>
        <translation>Die Mittelpunkte der größten Kreise, die in ein Teil passen.</translation>
    </message>
    <message>
        <source>The control that the program is written for.</source>
        <translation>Die Steuerung, für die das Programm geschrieben wird.</translation>
    </message>
    <message>
        <source>The curve that it is moved along.</source>
        <translation>Die Kurve, der er folgt.</translation>
    </message>
    <message>
        <source>The curve that the section follows: smooth, open or closed. Of a solid, some of its edges.</source>
        <translation>Die Kurve, der der Querschnitt folgt: glatt, offen oder geschlossen. Von einem Körper einige seiner Kanten.</translation>
    </message>
    <message>
        <source>the curve to sweep along</source>
        <translation>die Kurve für den Sweep</translation>
    </message>
    <message>
        <source>The edges to cut off.</source>
        <translation>Die Kanten, die gebrochen werden.</translation>
    </message>
    <message>
        <source>The edges to round.</source>
        <translation>Die Kanten, die verrundet werden.</translation>
    </message>
    <message>
        <source>The end of each line that lies at the point.</source>
        <translation>Das Ende jeder Zeile, das am Punkt liegt.</translation>
    </message>
    <message>
        <source>The exact rational surface, or a bicubic one within the tolerance.</source>
        <translation>Die exakte rationale Fläche oder eine bikubische innerhalb der Toleranz.</translation>
    </message>
    <message>
        <source>The exact surface or solid that one point sweeps under a motion in two parameters.</source>
        <translation>Die exakte Fläche oder der Körper, den ein Punkt unter einer Bewegung in zwei Parametern überstreicht.</translation>
    </message>
    <message>
        <source>The faces to open.</source>
        <translation>Die Seiten, die geöffnet werden.</translation>
    </message>
    <message>
        <source>The factors that get them; the trajectory has knots in v alone.</source>
        <translation>Die Faktoren, die sie bekommen; die Bahn hat nur Knoten in v.</translation>
    </message>
    <message>
        <source>The file to read.</source>
        <translation>Die Datei, die gelesen wird.</translation>
    </message>
    <message>
        <source>The first shape and the last.</source>
        <translation>Die erste und die letzte Form.</translation>
    </message>
    <message>
        <source>The fixed point of rotation and scaling.</source>
        <translation>Der feste Punkt von Drehung und Skalierung.</translation>
    </message>
    <message>
        <source>The flat face that is used when the profile is a solid.</source>
        <translation>Die ebene Seite, die gilt, wenn das Profil ein Körper ist.</translation>
    </message>
    <message>
        <source>The flat face to use as the part when the input is a solid.</source>
        <translation>Die ebene Seite, die als Teil gilt, wenn die Eingabe ein Körper ist.</translation>
    </message>
    <message>
        <source>The form and its measures.</source>
        <translation>Die Form und ihre Maße.</translation>
    </message>
    <message>
        <source>the frame of that number</source>
        <translation>das Bild mit der Nummer</translation>
    </message>
    <message>
        <source>The height of zero: the stock&apos;s top or bottom.</source>
        <translation>Die Höhe des Nullpunkts: Ober- oder Unterseite des Rohteils.</translation>
    </message>
    <message>
        <source>The in-between shapes of two or more control shapes.</source>
        <translation>Die Zwischenformen von zwei oder mehr Kontrollformen.</translation>
    </message>
    <message>
        <source>The in-between solids of two or more solids with any numbers of holes and corners.</source>
        <translation>Die Zwischenkörper von zwei oder mehr Körpern mit beliebig vielen Löchern und Ecken.</translation>
    </message>
    <message>
        <source>The motion that grows, before its edits; those of its file come first.</source>
        <translation>Die Bewegung, die wächst, vor ihren Änderungen; die ihrer Datei kommen zuerst.</translation>
    </message>
    <message>
        <source>the motion to begin with</source>
        <translation>die Bewegung für den Anfang</translation>
    </message>
    <message>
        <source>The motion to edit; edits of its file are applied first.</source>
        <translation>Die Bewegung, die bearbeitet wird; zuvor gelten die Änderungen ihrer Datei.</translation>
    </message>
    <message>
        <source>the only curve</source>
        <translation>die einzige Kurve</translation>
    </message>
    <message>
        <source>The outline at the bottom, then the one at the top.</source>
        <translation>Der untere Umriss, dann der obere.</translation>
    </message>
    <message>
        <source>The outline that is moved.</source>
        <translation>Der Umriss, der bewegt wird.</translation>
    </message>
    <message>
        <source>The part of a solid that a shape covers while it stays inside: thin walls and outer edges disappear.</source>
        <translation>Der Teil eines Körpers, den eine Form überdeckt, während sie darin bleibt: Dünne Wände und äußere Kanten verschwinden.</translation>
    </message>
    <message>
        <source>The part of an outline that a shape covers while it stays inside: thin parts and outer corners disappear.</source>
        <translation>Der Teil eines Umrisses, den eine Form überdeckt, während sie darin bleibt: dünne Teile und äußere Ecken verschwinden.</translation>
    </message>
    <message>
        <source>the part that it cuts</source>
        <translation>das Teil, das es schneidet</translation>
    </message>
    <message>
        <source>the path to move it along</source>
        <translation>den Pfad, dem er folgt</translation>
    </message>
    <message>
        <source>The point at the position: a corner, the middle of the base or the middle of the box.</source>
        <translation>Der Punkt an der Position: eine Ecke, die Mitte der Grundfläche oder die Mitte des Quaders.</translation>
    </message>
    <message>
        <source>The point on the base line of the first line, in the plane z = 0.</source>
        <translation>Der Punkt auf der Grundlinie der ersten Zeile, in der Ebene z = 0.</translation>
    </message>
    <message>
        <source>The points, first to last.</source>
        <translation>Die Punkte, vom ersten bis zum letzten.</translation>
    </message>
    <message>
        <source>the pulls and twists after it</source>
        <translation>die Züge und Verdrehungen danach</translation>
    </message>
    <message>
        <source>The same motion with more poles, so that pulls move smaller parts of it.</source>
        <translation>Dieselbe Bewegung mit mehr Polen, damit Züge kleinere Teile von ihr bewegen.</translation>
    </message>
    <message>
        <source>The segments, one after the other.</source>
        <translation>Die Segmente, eines nach dem anderen.</translation>
    </message>
    <message>
        <source>The sequence that the shape is taken out of.</source>
        <translation>Die Folge, aus der die Form genommen wird.</translation>
    </message>
    <message>
        <source>The sequence to play another way.</source>
        <translation>Die Folge, die anders gespielt wird.</translation>
    </message>
    <message>
        <source>The shape that has to fit inside.</source>
        <translation>Die Form, die hineinpassen muss.</translation>
    </message>
    <message>
        <source>The shape that is added to itself.</source>
        <translation>Die Form, die zu sich selbst addiert wird.</translation>
    </message>
    <message>
        <source>The shape that moves inside the solid.</source>
        <translation>Die Form, die sich im Körper bewegt.</translation>
    </message>
    <message>
        <source>The shape that moves outside the solid.</source>
        <translation>Die Form, die sich außerhalb des Körpers bewegt.</translation>
    </message>
    <message>
        <source>The shape to add to.</source>
        <translation>Die Form, zu der addiert wird.</translation>
    </message>
    <message>
        <source>The shape to add: a solid, a ball, a segment, a flat polygon or points.</source>
        <translation>Die Form, die addiert wird: ein Körper, eine Kugel, eine Strecke, ein ebenes Vieleck oder Punkte.</translation>
    </message>
    <message>
        <source>The shape to arrange.</source>
        <translation>Die Form, die angeordnet wird.</translation>
    </message>
    <message>
        <source>The shape to enclose, of one or several parts.</source>
        <translation>Die Form, die umschlossen wird, aus einem oder mehreren Teilen.</translation>
    </message>
    <message>
        <source>The shape whose boundary is followed, then the one that is swept.</source>
        <translation>Die Form, deren Rand verfolgt wird, dann die, die gezogen wird.</translation>
    </message>
    <message>
        <source>The shape: a tube is a bent one, a sheet an arched one.</source>
        <translation>Die Form: Ein Rohr ist gebogen, eine Bogenfläche gewölbt.</translation>
    </message>
    <message>
        <source>The shapes that are added: outlines, open curves, along which the others are swept, and points.</source>
        <translation>Die Formen, die addiert werden: Umrisse, offene Kurven, an denen die anderen entlanggeführt werden, und Punkte.</translation>
    </message>
    <message>
        <source>The value that takes the place of t at times t; linear between them.</source>
        <translation>Der Wert, der zu Zeiten t an die Stelle von t tritt; dazwischen linear.</translation>
    </message>
    <message>
        <source>The side of the tool with the material: climb cuts from thick to thin chips.</source>
        <translation>Die Seite des Werkzeugs mit dem Material: Gleichlauf schneidet vom dicken zum dünnen Span.</translation>
    </message>
    <message>
        <source>The smallest convex outline around a shape; its arcs stay arcs, and lines touch them.</source>
        <translation>Der kleinste konvexe Umriss um eine Form; Bögen bleiben Bögen, Geraden berühren sie.</translation>
    </message>
    <message>
        <source>Solids from t = 0 to t = 1; those between pull the morph towards them, as the poles of a Bezier curve do.</source>
        <translation>Körper von t = 0 bis t = 1; die dazwischen ziehen den Morph zu sich, wie die Pole einer Bézierkurve.</translation>
    </message>
    <message>
        <source>The solid that is changed.</source>
        <translation>Der Körper, der verändert wird.</translation>
    </message>
    <message>
        <source>The solid whose section at every height is the morph of two outlines, with planar faces.</source>
        <translation>Der Körper, dessen Schnitt in jeder Höhe der Morph zweier Umrisse ist, mit ebenen Flächen.</translation>
    </message>
    <message>
        <source>The space that one solid covers while its origin moves over the other.</source>
        <translation>Der Raum, den ein Körper überdeckt, während sein Ursprung über den anderen wandert.</translation>
    </message>
    <message>
        <source>The surfaces on the way of a motion through its pulls and twists, carried out one after another.</source>
        <translation>Die Flächen auf dem Weg einer Bewegung durch ihre Züge und Verdrehungen, eine nach der anderen ausgeführt.</translation>
    </message>
    <message>
        <source>The text; it may have several lines.</source>
        <translation>Der Text; er darf mehrere Zeilen haben.</translation>
    </message>
    <message>
        <source>The work offset of the control with the work&apos;s zero.</source>
        <translation>Die Nullpunktverschiebung der Steuerung mit dem Nullpunkt.</translation>
    </message>
    <message>
        <source>The work&apos;s zero: that of the drawing, or the stock&apos;s lower left corner or centre.</source>
        <translation>Der Nullpunkt: der der Zeichnung oder die untere linke Ecke oder die Mitte des Rohteils.</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of the walls.</source>
        <translation>Dicke der Wände.</translation>
    </message>
    <message>
        <source>through</source>
        <translation>durch</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>tool corner</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>tool diameter</source>
        <translation>Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>tool number</source>
        <translation>Werkzeugnummer</translation>
    </message>
    <message>
        <source>toolpath</source>
        <translation>Werkzeugweg</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>top radius</source>
        <translation>Radius oben</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Transform</source>
        <translation>Transformieren</translation>
    </message>
    <message>
        <source>translate</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>Translation, after rotation and scaling.</source>
        <translation>Verschiebung, nach Drehung und Skalierung.</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>durchsichtig</translation>
    </message>
    <message>
        <source>tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turned further, or set to that turn from the fixed axes.</source>
        <translation>Weitergedreht oder auf diese Drehung von den festen Achsen aus gesetzt.</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>Windungen</translation>
    </message>
    <message>
        <source>Turns of a helicoid; below 0: clockwise.</source>
        <translation>Windungen einer Wendelfläche; unter 0: im Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Turns the stripes of the zebra from level.</source>
        <translation>Dreht die Streifen des Zebras aus der Waagrechten.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Verdrehen</translation>
    </message>
    <message>
        <source>Two shapes morphed by matched vertices, by distance fields and by Minkowski sums, one beside the other.</source>
        <translation>Zwei Formen, gemorpht über zugeordnete Ecken, über Abstandsfelder und über Minkowski-Summen, nebeneinander.</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unite both to one body.</source>
        <translation>Vereinigt beide zu einem Körper.</translation>
    </message>
    <message>
        <source>Unite the copies to one body; off: an assembly of copies.</source>
        <translation>Vereinigt die Kopien zu einem Körper; aus: eine Baugruppe aus Kopien.</translation>
    </message>
    <message>
        <source>v</source>
        <translation>v</translation>
    </message>
    <message>
        <source>vector</source>
        <translation>Vektor</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Weight and slant.</source>
        <translation>Stärke und Neigung.</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Weights of poles of the trajectory.</source>
        <translation>Gewichte von Polen der Bahn.</translation>
    </message>
    <message>
        <source>What becomes of corners in the path.</source>
        <translation>Was aus Ecken im Pfad wird.</translation>
    </message>
    <message>
        <source>What becomes of it, in order: every pull and twist after it.</source>
        <translation>Was aus ihr wird, der Reihe nach: jedes Ziehen und Verdrehen danach.</translation>
    </message>
    <message>
        <source>What is made: triangles with their corners on the surface, the exact surface, or the solid in it.</source>
        <translation>Was entsteht: Dreiecke mit ihren Ecken auf der Fläche, die exakte Fläche oder der Körper darin.</translation>
    </message>
    <message>
        <source>What joins the point before to this one.</source>
        <translation>Was den Punkt davor mit diesem verbindet.</translation>
    </message>
    <message>
        <source>What lengths are written in: G21 or G20.</source>
        <translation>Worin Längen geschrieben werden: G21 oder G20.</translation>
    </message>
    <message>
        <source>What the faces tell of their surfaces: zebra stripes, Gaussian, mean or largest curvature in colours, or iso-curves.</source>
        <translation>Was die Seiten von ihren Flächen zeigen: Zebrastreifen, gaußsche, mittlere oder größte Krümmung in Farben, oder Iso-Kurven.</translation>
    </message>
    <message>
        <source>What the weight is multiplied by, above 0.</source>
        <translation>Womit das Gewicht multipliziert wird, über 0.</translation>
    </message>
    <message>
        <source>Where that place is to go.</source>
        <translation>Wohin diese Stelle kommen soll.</translation>
    </message>
    <message>
        <source>Where the limit shape is to run: drawn curves, edges of a solid, a cloud of points, or the vertices of a mesh.</source>
        <translation>Wo die Grenzform verlaufen soll: gezeichnete Kurven, Kanten eines Körpers, eine Punktwolke oder die Ecken eines Netzes.</translation>
    </message>
    <message>
        <source>Where the outline begins, in the plane z = 0.</source>
        <translation>Wo der Umriss beginnt, in der Ebene z = 0.</translation>
    </message>
    <message>
        <source>Where the segment ends.</source>
        <translation>Wo das Segment endet.</translation>
    </message>
    <message>
        <source>Whether an arc or a spline goes on in the direction of the segment before.</source>
        <translation>Ob ein Bogen oder Spline in Richtung des Segments davor weitergeht.</translation>
    </message>
    <message>
        <source>Whether it encloses an area. If its last segment does not return to the start, a line closes it.</source>
        <translation>Ob er eine Fläche umschließt. Kehrt sein letztes Segment nicht zum Anfang zurück, schließt ihn eine Linie.</translation>
    </message>
    <message>
        <source>Whether the ball&apos;s polyhedron lies inside it or around it.</source>
        <translation>Ob das Polyeder der Kugel in ihr oder um sie liegt.</translation>
    </message>
    <message>
        <source>Whether the copies stand in rows or round an axis.</source>
        <translation>Ob die Kopien in Reihen oder um eine Achse stehen.</translation>
    </message>
    <message>
        <source>Whether the corners lie on the circle (inscribed) or the sides touch it (circumscribed).</source>
        <translation>Ob die Ecken auf dem Kreis liegen (einbeschrieben) oder die Seiten ihn berühren (umbeschrieben).</translation>
    </message>
    <message>
        <source>Whether the edits of the file belong to the motion that is read.</source>
        <translation>Ob die Änderungen der Datei zu der gelesenen Bewegung gehören.</translation>
    </message>
    <message>
        <source>Whether the polyhedron lies inside the ball or around it.</source>
        <translation>Ob das Polyeder in der Kugel oder um sie liegt.</translation>
    </message>
    <message>
        <source>Whether the walls grow into the solid or around it.</source>
        <translation>Ob die Wände in den Körper hinein oder um ihn herum wachsen.</translation>
    </message>
    <message>
        <source>Which control points may move: support, paper, or rings:N for the support grown by N rings.</source>
        <translation>Welche Kontrollpunkte sich bewegen dürfen: support, paper oder rings:N für den um N Ringe gewachsenen Träger.</translation>
    </message>
    <message>
        <source>Which frame, counted from 1.</source>
        <translation>Welches Bild, gezählt ab 1.</translation>
    </message>
    <message>
        <source>Which loops of the boundary are followed.</source>
        <translation>Welche Schleifen des Randes verfolgt werden.</translation>
    </message>
    <message>
        <source>Which point of the profile follows the path: the middle of its area or the origin.</source>
        <translation>Welcher Punkt des Profils dem Pfad folgt: die Mitte seiner Fläche oder der Ursprung.</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width and height in pixels.</source>
        <translation>Breite und Höhe in Pixeln.</translation>
    </message>
    <message>
        <source>Width of the chamfer on both faces.</source>
        <translation>Breite der Fase auf beiden Seiten.</translation>
    </message>
    <message>
        <source>Width on the second of the two faces; 0: as on the first.</source>
        <translation>Breite auf der zweiten der beiden Seiten; 0: wie auf der ersten.</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Write solids as solids (entity 186); off: as loose trimmed surfaces, for programs that read nothing else.</source>
        <translation>Schreibt Körper als Körper (Entität 186); aus: als lose beschnittene Flächen, für Programme, die nichts anderes lesen.</translation>
    </message>
    <message>
        <source>Write text instead of binary.</source>
        <translation>Schreibt Text statt binär.</translation>
    </message>
    <message>
        <source>zebra</source>
        <translation>Zebra</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>zero height</source>
        <translation>Höhe des Nullpunkts</translation>
    </message>
    <message>
        <source>A shape to grow by in place of the ball, about the origin.</source>
        <translation>Eine Form, um die er statt um die Kugel wächst, um den Ursprung.</translation>
    </message>
    <message>
        <source>A shape to melt by in place of the ball, about the origin.</source>
        <translation>Eine Form, um die er statt um die Kugel schmilzt, um den Ursprung.</translation>
    </message>
    <message>
        <source>How many times as large as drawn an element is taken.</source>
        <translation>Wievielmal so groß wie gezeichnet ein Element genommen wird.</translation>
    </message>
    <message>
        <source>Growth of the size over the frames.</source>
        <translation>Wie die Größe über die Bilder wächst.</translation>
    </message>
    <message>
        <source>The share of the whole size at times from 0 to 1; linear between them.</source>
        <translation>Der Anteil der ganzen Größe zu Zeiten von 0 bis 1; dazwischen linear.</translation>
    </message>
    <message>
        <source>How far it melts: by the radius or size, or as far as anything is left.</source>
        <translation>Wie weit er schmilzt: um den Radius oder die Größe, oder so weit noch etwas übrig ist.</translation>
    </message>
    <message>
        <source>What is left is rounded by this share of the depth, as ice is: edges and thin places go first.</source>
        <translation>Was übrig ist, wird um diesen Teil der Tiefe gerundet, wie Eis: Kanten und dünne Stellen gehen zuerst.</translation>
    </message>
    <message>
        <source>One number for each solid after the first, instead of t; all equal, they are t.</source>
        <translation>Eine Zahl für jeden Körper nach dem ersten, statt t; sind alle gleich, sind sie t.</translation>
    </message>
    <message>
        <source>Round solid</source>
        <translation>Körper runden</translation>
    </message>
    <message>
        <source>A solid whose edges and corners are all rounded by a ball, as far as there is room for it.</source>
        <translation>Ein Körper, dessen Kanten und Ecken alle durch eine Kugel gerundet sind, soweit Platz für sie ist.</translation>
    </message>
    <message>
        <source>Which edges are rounded: outer ones, inner ones, or both. Thin walls go with the outer ones, narrow slots with the inner ones.</source>
        <translation>Welche Kanten gerundet werden: äußere, innere oder beide. Mit den äußeren gehen dünne Wände, mit den inneren enge Schlitze.</translation>
    </message>
    <message>
        <source>until</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>reflex</source>
        <translation>einspringend</translation>
    </message>
    <message>
        <source>solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts mehr</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>A part in its stock on the machine, with clamps and the work&apos;s zero.</source>
        <translation>Ein Teil in seinem Rohteil auf der Maschine, mit Spannmitteln und Nullpunkt.</translation>
    </message>
    <message>
        <source>The solid that is to be made, or its outline.</source>
        <translation>Der Körper, der entstehen soll, oder sein Umriss.</translation>
    </message>
    <message>
        <source>a part to set up</source>
        <translation>ein Teil zum Aufspannen</translation>
    </message>
    <message>
        <source>A solid that the part is cut from, drawn around it; without one it is a box or a cylinder.</source>
        <translation>Ein Körper, aus dem das Teil geschnitten wird, um dieses gezeichnet; ohne ihn ein Quader oder Zylinder.</translation>
    </message>
    <message>
        <source>a solid that the part is cut from</source>
        <translation>ein Körper, aus dem das Teil geschnitten wird</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>z is up, as drawn</source>
        <translation>z ist oben, wie gezeichnet</translation>
    </message>
    <message>
        <source>The flat face that looks up.</source>
        <translation>Die ebene Fläche, die nach oben schaut.</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>stock form</source>
        <translation>Form des Rohteils</translation>
    </message>
    <message>
        <source>The form of the stock.</source>
        <translation>Die Form des Rohteils.</translation>
    </message>
    <message>
        <source>stock above</source>
        <translation>Aufmaß oben</translation>
    </message>
    <message>
        <source>stock below</source>
        <translation>Aufmaß unten</translation>
    </message>
    <message>
        <source>How far the stock reaches beside the part.</source>
        <translation>Wie weit das Rohteil seitlich über das Teil hinausreicht.</translation>
    </message>
    <message>
        <source>How far the stock reaches above the part.</source>
        <translation>Wie weit das Rohteil über das Teil hinausreicht.</translation>
    </message>
    <message>
        <source>How far the stock reaches below the part.</source>
        <translation>Wie weit das Rohteil unter das Teil hinabreicht.</translation>
    </message>
    <message>
        <source>clamps</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Boxes that hold the stock; no part of the tool may touch them.</source>
        <translation>Quader, die das Rohteil halten; kein Teil des Werkzeugs darf sie berühren.</translation>
    </message>
    <message>
        <source>Its lowest corner, as the part is drawn.</source>
        <translation>Seine unterste Ecke, wie das Teil gezeichnet ist.</translation>
    </message>
    <message>
        <source>Its size along x, y and z.</source>
        <translation>Seine Größe entlang x, y und z.</translation>
    </message>
    <message>
        <source>The height of zero: the stock&apos;s top or bottom, or that of the drawing.</source>
        <translation>Die Höhe des Nullpunkts: Ober- oder Unterseite des Rohteils oder die der Zeichnung.</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Verfahrweg</translation>
    </message>
    <message>
        <source>How far the machine moves the tool&apos;s tip; 0,0,0: not known.</source>
        <translation>Wie weit die Maschine die Werkzeugspitze bewegt; 0,0,0: nicht bekannt.</translation>
    </message>
    <message>
        <source>zero at</source>
        <translation>Nullpunkt bei</translation>
    </message>
    <message>
        <source>Where the work&apos;s zero lies in the travel, from its lowest corner.</source>
        <translation>Wo der Nullpunkt im Verfahrweg liegt, von dessen unterster Ecke.</translation>
    </message>
    <message>
        <source>How the part is held: the whole tool is swept against the solid and the clamps, from the work&apos;s zero.</source>
        <translation>Wie das Teil gespannt ist: Das ganze Werkzeug wird gegen Körper und Spannmittel geführt, vom Nullpunkt aus.</translation>
    </message>
    <message>
        <source>the setup that it runs in</source>
        <translation>die Aufspannung, in der es läuft</translation>
    </message>
    <message>
        <source>How the part is held: it gives the stock, the zero and the heights, and nothing in it may be hit.</source>
        <translation>Wie das Teil gespannt ist: Daraus kommen Rohteil, Nullpunkt und Höhen, und nichts darin darf getroffen werden.</translation>
    </message>
    <message>
        <source>the setup that the part is cut in</source>
        <translation>die Aufspannung, in der das Teil geschnitten wird</translation>
    </message>
    <message>
        <source>flute length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Length of the flutes; 0: the shank is not checked.</source>
        <translation>Länge der Schneiden; 0: der Schaft wird nicht geprüft.</translation>
    </message>
    <message>
        <source>shank diameter</source>
        <translation>Schaftdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the shank above the flutes; 0: not checked.</source>
        <translation>Durchmesser des Schafts über den Schneiden; 0: nicht geprüft.</translation>
    </message>
    <message>
        <source>stick out</source>
        <translation>Auskraglänge</translation>
    </message>
    <message>
        <source>From the tip to the holder; 0: the holder is not checked.</source>
        <translation>Von der Spitze bis zum Halter; 0: der Halter wird nicht geprüft.</translation>
    </message>
    <message>
        <source>holder diameter</source>
        <translation>Halterdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the holder; 0: not checked.</source>
        <translation>Durchmesser des Halters; 0: nicht geprüft.</translation>
    </message>
    <message>
        <source>holder length</source>
        <translation>Halterlänge</translation>
    </message>
    <message>
        <source>Length of the holder; 0: without end.</source>
        <translation>Länge des Halters; 0: ohne Ende.</translation>
    </message>
    <message>
        <source>A medial axis is written in space, the radius of its discs as height; off: flat.</source>
        <translation>Eine Mittelachse wird räumlich geschrieben, der Radius ihrer Kreise als Höhe; aus: flach.</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Abtragen</translation>
    </message>
    <message>
        <source>The stock as a program leaves it, or has left it so far.</source>
        <translation>Das Rohteil, wie ein Programm es zurücklässt oder bis dahin zurückgelassen hat.</translation>
    </message>
    <message>
        <source>A toolpath or a G-code program, from the work&apos;s zero of the setup.</source>
        <translation>Ein Werkzeugweg oder ein G-Code-Programm, vom Nullpunkt der Aufspannung aus.</translation>
    </message>
    <message>
        <source>a program to watch</source>
        <translation>ein Programm zum Zusehen</translation>
    </message>
    <message>
        <source>The stock, and where it stands.</source>
        <translation>Das Rohteil, und wo es steht.</translation>
    </message>
    <message>
        <source>How far the program has gone, as a share of its time.</source>
        <translation>Wie weit das Programm gelaufen ist, als Anteil seiner Zeit.</translation>
    </message>
    <message>
        <source>Number of shapes of a sequence from the whole stock on; 0 makes only the last one.</source>
        <translation>Anzahl der Formen einer Folge vom ganzen Rohteil an; 0 macht nur die letzte.</translation>
    </message>
    <message>
        <source>How many cells the stock is divided into, seen from above.</source>
        <translation>In wie viele Zellen das Rohteil geteilt wird, von oben gesehen.</translation>
    </message>
</context>
<context>
    <name>Warnings</name>
    <message>
        <source>Nothing is edited yet: there is no place.</source>
        <translation>Noch wird nichts bearbeitet: Es gibt keine Stelle.</translation>
    </message>
</context>
</TS>
