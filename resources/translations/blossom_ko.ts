<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko_KR">
<context>
    <name></name>
    <message>
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the window; system follows the desktop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the window, from the next start on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In which lengths are shown; any unit may be typed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digits after the point where lengths are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which mouse buttons turn, shift and zoom the view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between a shape and the polygons that are drawn and exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a document when it is opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep a copy of unsaved changes that is offered after a crash.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time between two such copies, in minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processor cores to compute with; 0 takes all of them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference: built in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Measurements</name>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of centres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Major radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minor radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size along y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size along z</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::modeling</name>
    <message>
        <source>grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>45°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aligned with the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at right angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossing of help lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DragTool</name>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a handle to change the shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go to place %1 · Ctrl: no snapping · Esc takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DrawTool</name>
    <message>
        <source>The outline would meet itself at (%1, %2); move a point or take some back with Backspace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This point makes no segment; choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the first point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a point that the arc passes, or type its radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line: click its end, or type a length and, after &lt;, an angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tangent arc: click its end; A for three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc: click its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spline: click the next point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter places the point, Tab changes between length and angle, Esc leaves the entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L line, A arc, S spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backspace takes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter finishes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl: no snapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc leaves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::modeling::EditTool</name>
    <message>
        <source>the first point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too little would be left of the outline; delete the feature itself instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click to insert a point here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag points · double-click a segment to insert one · Delete removes the chosen one · Enter or Esc leaves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::modeling::ShapeTool</name>
    <message>
        <source>the shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rounding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui</name>
    <message>
        <source>Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::AboutDialog</name>
    <message>
        <source>The text of the licence is not installed. It can be read at https://www.gnu.org/licenses/gpl-3.0.txt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Blossom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy versions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blossom %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A workbench for shapes that morph, sweep, grow and melt.
Free software under the GNU General Public License, version 3 or later.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Chip</name>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ChoiceField</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be given</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ColorField</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be given</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature, a page of the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return or click: %1 · Up and down: choose · Esc: close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be done now. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveEditor</name>
    <message>
        <source>Click to add a point, drag to move it, right click or Delete to remove it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click to add a point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveField</name>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t of the chosen point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value of the chosen point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentCommands</name>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do again what was taken back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected features out, to be pasted elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the selected features, and what they are made from, to be pasted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the features that were copied, in this document or another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the selected features once more, made from the same inputs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected feature another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or &amp;hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the selected features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only the selected features; once more: what was shown before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sho&amp;w everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Suppress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the selected features out of the computation, or take them in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the selected features one place further up in the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the selected features one place further down in the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select every feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select no feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for features by name, type or state.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit to &amp;selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show just the selected features, as large as fits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been changed yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was taken back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute a&amp;gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End &amp;isolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a feature first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select one feature only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Make from it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentModel</name>
    <message>
        <source>suppressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentPage</name>
    <message>
        <source>Computing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything could be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Working</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handles of %1 cannot be shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open what is readable</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTabs</name>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTree</name>
    <message>
        <source>Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · Click: select · Ctrl+click: select more · Double click: rename · Drag: reorder · Right click: more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release: move here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End isolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolate %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute %1 features again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete that too, or suppress: what is suppressed stays but is not computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete them too, or suppress: what is suppressed stays but is not computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is used by %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete all %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1 features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no features on the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select some and copy them first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1 features</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTreePanel</name>
    <message>
        <source>Name, type or state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DOCUMENT</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ErrorBar</name>
    <message>
        <source>Dismiss (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ExportDialog</name>
    <message>
        <source>Shapes of these kinds do not go into one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureHeader</name>
    <message>
        <source>Name of the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the feature; type another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read about it in the manual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureMenus</name>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that can be read (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes a %1 as &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes %1 × %2 as &quot;%3&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: choose a file with a %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select in the document: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs at least %2 %3 as &quot;%4&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureToolBar</name>
    <message>
        <source>Everything of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::FileField</name>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of the type %2. The value before is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. The value before is kept.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::FindField</name>
    <message>
        <source>Find a command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::HelpMenu</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read how everything works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the &amp;selected feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The manual&apos;s page of the selected feature: inputs, parameters, examples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How to move around, and every key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A walk through the window in four steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Blossom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Versions and licence.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::InputEditor</name>
    <message>
        <source>Add an input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing else fits here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs this feature itself; taking it would go round in a circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, which does not fit here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click what %1 is to be; Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no room for more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsDelegate</name>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsList</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsPanel</name>
    <message>
        <source>Jobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: cancel %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cross: cancel · Right click: more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right click: copy the message, forget what has finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget what has finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is being computed, read or written.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::KeyRecorder</name>
    <message>
        <source>Press keys…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No keys: click to set</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListField</name>
    <message>
        <source>Add an item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an item to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListRow</name>
    <message>
        <source>Drag to another place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move or copy this item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogAndJobs</name>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Jobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what is being computed, read and written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what has happened so far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JOBS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LOG</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogList</name>
    <message>
        <source>Opened %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy what is selected, or everything shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::MainWindow</name>
    <message>
        <source>Not every plugin could be loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a co&amp;mmand…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature or a page of the manual by a few letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at everything as when it was opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Come nearer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without perspective: equal lengths look equal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the ground grid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 selected results as one file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 visible results as one file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open documents, or geometry in new ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a s&amp;ample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show samples and recent documents.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add geometry from files to this document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the selected results, or all that is visible, as STEP, STL, a picture, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this document under another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the workbench.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the document in the next tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the document in the tab before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close ot&amp;hers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close every document but this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes it off this list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blossom documents (*.blossom)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no extension that Blossom reads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 files cannot be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since it was opened here, somebody else has written it. Saving replaces what they wrote.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving replaces it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No safety copy of %1 can be kept: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: find a command · Drop files to open them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualText</name>
    <message>
        <source># No such page

The manual has no page &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualWindow</name>
    <message>
        <source>Blossom manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – Blossom manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in the manual has all of these words.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasurePanel</name>
    <message>
        <source>Click a face, an edge or a point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the figures (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the measurement (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete all measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MEASUREMENTS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasureTool</name>
    <message>
        <source>Click: measure to %1 · Enter: keep as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a second part · Enter: keep as it is · Del: delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: measure %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a face, an edge or a point to measure it · Esc: finish</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Measurements</name>
    <message>
        <source>What was measured is no longer in the document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no shape at present.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, face %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, edge %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Navigation</name>
    <message>
        <source>left and middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select by a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel: zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click: fit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::NumberField</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Drag sideways to change it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ParameterField</name>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::PreferencesCommands</name>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the keys of every command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look, units, navigation, autosave and threads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::PropertyPanel</name>
    <message>
        <source>PROPERTIES</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is open yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a feature to see what it is made from and what it came to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plugin that makes &quot;%1&quot; is not installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>INPUTS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RESULT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another file is still being read or written. Wait for it or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::RatioSlider</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Recovery</name>
    <message>
        <source>Looking for unsaved documents</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::RecoveryBar</name>
    <message>
        <source>Recover all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not now: they are offered again at the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, last step: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Was never saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A document was not saved when Blossom last ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 documents were not saved when Blossom last ended.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ResultTable</name>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the cache</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy name and value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all results</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionPanel</name>
    <message>
        <source>Flip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away the other side (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything whole again (Del)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the x axis (X)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the y axis (Y)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the z axis (Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel to a face that you pick (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset of the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it cuts, such as 12.5 or 1/2 in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionTool</name>
    <message>
        <source>Click a face: the section becomes parallel to it · Esc: keep the direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl: in steps of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: move the section along its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the handle · X, Y, Z: direction · P: of a face · F: flip · Up, Down: a step · Del: off · Esc: finish</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Session</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing was cancelled; what was ready is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is as it was after &quot;%2&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ShortcutEditor</name>
    <message>
        <source>Search commands and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Standard keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take them from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the keys and press others, or press Enter in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a command to change its keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already belongs to &quot;%2&quot; in %3.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::StartPage</name>
    <message>
        <source>RECENT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SAMPLES</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with a shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a sample, or drop files anywhere on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a document with geometry from files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all jobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 jobs: </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::SubShapeField</name>
    <message>
        <source>Pick in the view: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none; pick in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One must be given; pick another one instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click every %1 for %2, again to let go; Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the %1 for %2; Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is not a part of an input of this feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is no %1 but a %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Swatch</name>
    <message>
        <source>Choose another colour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::SwitchBox</name>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::TextField</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tile</name>
    <message>
        <source>Pinned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tour</name>
    <message>
        <source>Begin with a sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The start page opens samples and your last documents with one click. Files can be dropped anywhere on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every feature stands here, above what is made from it, with what it came to below its name. A failing feature says why; the rest of the document lives on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected shows its parameters and its result. Values may be expressions with units, such as 3cm + 1/2 in, and every change can be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas and palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do. %1 finds every command by name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::TourBubble</name>
    <message>
        <source>&amp;Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::UnsavedDialog</name>
    <message>
        <source>Save all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 documents have changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those that are ticked are saved; the changes of the others are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::VectorField</name>
    <message>
        <source>Pick a point in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a face in the view; its normal is taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where %1 is to be; Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a face whose normal is to be %1; Esc ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCommands</name>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;eatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click in the view selects whole features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click in the view selects faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click in the view selects edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click in the view selects points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Any part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click in the view selects the nearest face, edge or point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw faces and their edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw faces alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw edges alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure lengths, distances, angles, radii and areas by clicking.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the model open with a plane that can be dragged.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCube</name>
    <message>
        <source>Click: look from %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewWidget</name>
    <message>
        <source>The graphics driver has no OpenGL 3.2, which the view needs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orbiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zooming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects what the box touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects what lies wholly in the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grid %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1   y %2 mm   ·   %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
