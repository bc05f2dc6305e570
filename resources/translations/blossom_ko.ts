<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko_KR" sourcelanguage="en_GB">
<context>
    <name>Manual</name>
    <message>
        <source>More</source>
        <translation>기타</translation>
    </message>
    <message>
        <source>Reference: %1</source>
        <translation>참조: %1</translation>
    </message>
    <message>
        <source>Reference: built in</source>
        <translation>참조: 기본 제공</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
</context>
<context>
    <name>Measurements</name>
    <message>
        <source>Distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>x 방향</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>y 방향</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>z 방향</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>반각</translation>
    </message>
    <message>
        <source>Distance of planes</source>
        <translation>평면 사이 거리</translation>
    </message>
    <message>
        <source>Distance of axes</source>
        <translation>축 사이 거리</translation>
    </message>
    <message>
        <source>Distance of centres</source>
        <translation>중심 사이 거리</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>중심 x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>중심 y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>중심 z</translation>
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
        <translation>길이</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>반지름</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>지름</translation>
    </message>
    <message>
        <source>Major radius</source>
        <translation>큰 반지름</translation>
    </message>
    <message>
        <source>Minor radius</source>
        <translation>작은 반지름</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>면적</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>둘레</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>부피</translation>
    </message>
    <message>
        <source>Size along x</source>
        <translation>x 방향 크기</translation>
    </message>
    <message>
        <source>Size along y</source>
        <translation>y 방향 크기</translation>
    </message>
    <message>
        <source>Size along z</source>
        <translation>z 방향 크기</translation>
    </message>
</context>
<context>
    <name>Registry</name>
    <message>
        <source>theme</source>
        <translation>테마</translation>
    </message>
    <message>
        <source>language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>length unit</source>
        <translation>길이 단위</translation>
    </message>
    <message>
        <source>navigation</source>
        <translation>탐색</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>투영</translation>
    </message>
    <message>
        <source>autosave</source>
        <translation>자동 저장</translation>
    </message>
    <message>
        <source>autosave minutes</source>
        <translation>자동 저장 간격(분)</translation>
    </message>
    <message>
        <source>threads</source>
        <translation>스레드</translation>
    </message>
    <message>
        <source>system</source>
        <translation>시스템</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>원근</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>평행</translation>
    </message>
    <message>
        <source>drawing tolerance</source>
        <translation>표시 허용 오차</translation>
    </message>
    <message>
        <source>zebra stripes</source>
        <translation>얼룩말 줄무늬</translation>
    </message>
    <message>
        <source>zebra angle</source>
        <translation>얼룩말 줄무늬 각도</translation>
    </message>
    <message>
        <source>iso curves</source>
        <translation>아이소커브</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::InfluenceChart</name>
    <message>
        <source>Influence of each control shape over t</source>
        <translation>t에 따른 각 제어 도형의 영향</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::MorphCard</name>
    <message>
        <source>Ladder</source>
        <translation>사다리</translation>
    </message>
    <message>
        <source>Draw the shapes between the control shapes and this one (L)</source>
        <translation>제어 도형과 이 도형 사이의 도형 그리기 (L)</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>모프</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>영향</translation>
    </message>
    <message>
        <source>Draw how much each control shape counts over t</source>
        <translation>t에 따른 각 제어 도형의 비중 그리기</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>경로</translation>
    </message>
    <message>
        <source>Draw the way of the sequence through the blossom</source>
        <translation>블로섬을 지나는 시퀀스의 경로 그리기</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::MorphTool</name>
    <message>
        <source>Move %1 in the morph</source>
        <translation>모프에서 %1 옮기기</translation>
    </message>
    <message>
        <source>Drag to move %1 in the morph</source>
        <translation>끌어서 모프에서 %1 을(를) 옮기기</translation>
    </message>
    <message>
        <source>Drag to move %1 in the morph · double click puts it back</source>
        <translation>끌어서 모프에서 %1 을(를) 옮기기 · 두 번 클릭하면 되돌림</translation>
    </message>
    <message>
        <source>Scale %1 in the morph</source>
        <translation>모프에서 %1 크기 바꾸기</translation>
    </message>
    <message>
        <source>Turn %1 in the morph</source>
        <translation>모프에서 %1 돌리기</translation>
    </message>
    <message>
        <source>Put %1 back as it was drawn</source>
        <translation>%1 을(를) 그린 대로 되돌리기</translation>
    </message>
    <message>
        <source>t %1 · area %2</source>
        <translation>t %1 · 넓이 %2</translation>
    </message>
    <message>
        <source>A morph with a degree or knots has no ladder.</source>
        <translation>차수나 매듭이 있는 모프에는 사다리가 없습니다.</translation>
    </message>
    <message>
        <source>Three control shapes or more have a ladder.</source>
        <translation>사다리는 제어 도형이 셋 이상일 때 있습니다.</translation>
    </message>
    <message>
        <source>Some of the ladder takes too long to be drawn.</source>
        <translation>사다리의 일부는 그리는 데 너무 오래 걸립니다.</translation>
    </message>
    <message>
        <source>Type how many times as large · Enter takes it · Esc leaves it to the mouse</source>
        <translation>몇 배인지 입력 · Enter로 적용 · Esc로 마우스에 맡김</translation>
    </message>
    <message>
        <source>%1 is %2 times as large as drawn · type a number · Ctrl: no steps · Esc takes it back</source>
        <translation>%1 이(가) 그린 것의 %2배 · 숫자 입력 · Ctrl: 단계 끄기 · Esc로 취소</translation>
    </message>
    <message>
        <source>Type the angle · Enter takes it · Esc leaves it to the mouse</source>
        <translation>각도 입력 · Enter로 적용 · Esc로 마우스에 맡김</translation>
    </message>
    <message>
        <source>%1 is turned by %2° · type a number · Ctrl: no steps · Esc takes it back</source>
        <translation>%1 이(가) %2° 돌아감 · 숫자 입력 · Ctrl: 단계 끄기 · Esc로 취소</translation>
    </message>
    <message>
        <source>Type x, y · Enter takes it · Esc leaves it to the mouse</source>
        <translation>x, y 입력 · Enter로 적용 · Esc로 마우스에 맡김</translation>
    </message>
    <message>
        <source>%1 is moved by %2 · type x, y · Ctrl: no snapping · Esc takes it back</source>
        <translation>%1 이(가) %2 만큼 옮겨짐 · x, y 입력 · Ctrl: 스냅 끄기 · Esc로 취소</translation>
    </message>
    <message>
        <source>Drag to scale %1 in the morph</source>
        <translation>끌어서 모프에서 %1 크기 바꾸기</translation>
    </message>
    <message>
        <source>Drag to scale %1 in the morph · double click: as large as drawn</source>
        <translation>끌어서 모프에서 %1 크기 바꾸기 · 두 번 클릭: 그린 크기로</translation>
    </message>
    <message>
        <source>Drag to turn %1 in the morph</source>
        <translation>끌어서 모프에서 %1 돌리기</translation>
    </message>
    <message>
        <source>Drag to turn %1 in the morph · double click: as it was drawn</source>
        <translation>끌어서 모프에서 %1 돌리기 · 두 번 클릭: 그린 대로</translation>
    </message>
    <message>
        <source>Drag the number of a control shape to move it, the square or the dot on its ring to scale or turn it · L: ladder</source>
        <translation>제어 도형의 번호를 끌면 옮기고, 고리의 네모나 점을 끌면 크기를 바꾸거나 돌림 · L: 사다리</translation>
    </message>
    <message>
        <source>A morph with a degree or knots has no path.</source>
        <translation>차수나 매듭이 있는 모프에는 경로가 없습니다.</translation>
    </message>
    <message>
        <source>Level %1, leg %2: t %3 · area %4</source>
        <translation>단계 %1, 변 %2: t %3 · 면적 %4</translation>
    </message>
    <message>
        <source>Draw the path of the morph</source>
        <translation>모프의 경로 그리기</translation>
    </message>
    <message>
        <source>Click to show the whole ladder again</source>
        <translation>클릭하면 사다리 전체를 다시 보여 줍니다</translation>
    </message>
    <message>
        <source>Click to show the shape on this leg of the ladder</source>
        <translation>클릭하면 사다리의 이 변에 있는 도형을 보여 줍니다</translation>
    </message>
</context>
<context>
    <name>blossom::minkowski::PathPad</name>
    <message>
        <source>Path through the blossom</source>
        <translation>블로섬을 지나는 경로</translation>
    </message>
    <message>
        <source>Drag a point; double-click to put one in, Delete or a right click to take one out</source>
        <translation>점을 끕니다. 두 번 클릭하면 넣고, Delete나 오른쪽 클릭으로 뺍니다</translation>
    </message>
</context>
<context>
    <name>blossom::modeling</name>
    <message>
        <source>grid</source>
        <translation>격자</translation>
    </message>
    <message>
        <source>on the curve</source>
        <translation>곡선 위</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>수평</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>수직</translation>
    </message>
    <message>
        <source>45°</source>
        <translation>45°</translation>
    </message>
    <message>
        <source>aligned with the start</source>
        <translation>시작점에 맞춤</translation>
    </message>
    <message>
        <source>straight on</source>
        <translation>곧게</translation>
    </message>
    <message>
        <source>at right angles</source>
        <translation>직각</translation>
    </message>
    <message>
        <source>crossing of help lines</source>
        <translation>보조선의 교점</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>수선</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>중점</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>중심</translation>
    </message>
    <message>
        <source>point</source>
        <translation>점</translation>
    </message>
    <message>
        <source>start</source>
        <translation>시작점</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DragTool</name>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>Drag a handle to change the shape</source>
        <translation>손잡이를 끌어 형상을 바꿉니다</translation>
    </message>
    <message>
        <source>Let go to place %1 · Ctrl: no snapping · Esc takes it back</source>
        <translation>놓으면 %1이(가) 자리 잡음 · Ctrl: 스냅 없이 · Esc: 되돌리기</translation>
    </message>
    <message>
        <source>Drag to move %1</source>
        <translation>끌어서 %1 이동</translation>
    </message>
    <message>
        <source>The outline cannot have this size.</source>
        <translation>윤곽선은 이 크기가 될 수 없습니다.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Type the size · Enter takes it · Esc leaves it as it is</source>
        <translation>크기 입력 · Enter: 적용 · Esc: 그대로 두기</translation>
    </message>
    <message>
        <source>Double-click to type %1</source>
        <translation>두 번 클릭하여 %1 입력</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::DrawTool</name>
    <message>
        <source>The outline would meet itself at (%1, %2); move a point or take some back with Backspace.</source>
        <translation>윤곽이 (%1, %2)에서 자기 자신과 만납니다. 점을 옮기거나 백스페이스로 되돌리십시오.</translation>
    </message>
    <message>
        <source>This point makes no segment; choose another.</source>
        <translation>이 점으로는 선분이 만들어지지 않습니다. 다른 점을 고르십시오.</translation>
    </message>
    <message>
        <source>Draw outline</source>
        <translation>윤곽 그리기</translation>
    </message>
    <message>
        <source>Click the first point, or type @ and its x,y</source>
        <translation>첫 점을 클릭하십시오 (또는 @ 다음에 x,y 입력)</translation>
    </message>
    <message>
        <source>Click a point that the arc passes, or type its radius</source>
        <translation>호가 지나는 점을 클릭하거나 반지름을 입력하십시오</translation>
    </message>
    <message>
        <source>Line: click its end, or type a length and, after &lt;, an angle</source>
        <translation>직선: 끝점을 클릭하거나 길이를, &lt; 뒤에 각도를 입력하십시오</translation>
    </message>
    <message>
        <source>Tangent arc: click its end; A for three points</source>
        <translation>접선 호: 끝점을 클릭하십시오. A: 세 점</translation>
    </message>
    <message>
        <source>Arc: click its end</source>
        <translation>호: 끝점을 클릭하십시오</translation>
    </message>
    <message>
        <source>Spline: click the next point</source>
        <translation>스플라인: 다음 점을 클릭하십시오</translation>
    </message>
    <message>
        <source>Enter places the point, Tab changes between length and angle, Esc leaves the entry</source>
        <translation>Enter: 점 놓기, Tab: 길이와 각도 전환, Esc: 입력 끝내기</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>클릭하면 윤곽이 닫힙니다</translation>
    </message>
    <message>
        <source>L line, A arc, S spline</source>
        <translation>L 직선, A 호, S 스플라인</translation>
    </message>
    <message>
        <source>Backspace takes back</source>
        <translation>백스페이스: 되돌리기</translation>
    </message>
    <message>
        <source>Enter finishes</source>
        <translation>Enter: 끝내기</translation>
    </message>
    <message>
        <source>Ctrl: no snapping</source>
        <translation>Ctrl: 스냅 없이</translation>
    </message>
    <message>
        <source>Esc leaves</source>
        <translation>Esc: 나가기</translation>
    </message>
    <message>
        <source>what is typed</source>
        <translation>입력한 내용</translation>
    </message>
    <message>
        <source>the last point</source>
        <translation>마지막 점</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::EditTool</name>
    <message>
        <source>the first point</source>
        <translation>첫 점</translation>
    </message>
    <message>
        <source>a point of the outline</source>
        <translation>윤곽의 점</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>점 넣기</translation>
    </message>
    <message>
        <source>Remove a point</source>
        <translation>점 빼기</translation>
    </message>
    <message>
        <source>Too little would be left of the outline; delete the feature itself instead.</source>
        <translation>윤곽이 너무 적게 남습니다. 피처 자체를 삭제하십시오.</translation>
    </message>
    <message>
        <source>Double-click to insert a point here</source>
        <translation>두 번 클릭하면 여기에 점을 넣습니다</translation>
    </message>
    <message>
        <source>Drag points · double-click a segment to insert one · Delete removes the chosen one · Enter or Esc leaves</source>
        <translation>점 끌기 · 선분 두 번 클릭: 점 넣기 · Delete: 고른 점 빼기 · Enter 또는 Esc: 나가기</translation>
    </message>
    <message>
        <source>the length of this side</source>
        <translation>이 변의 길이</translation>
    </message>
    <message>
        <source>This side is slanted, and only level and upright sides keep an expression with names: type its value, or write expressions for its points under &quot;segments&quot;.</source>
        <translation>이 변은 기울어져 있습니다. 이름이 든 식은 수평이나 수직인 변만 유지합니다. 값을 입력하거나, &quot;Segments&quot;에서 그 점들을 식으로 쓰십시오.</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::ShapeTool</name>
    <message>
        <source>the shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>the corner</source>
        <translation>모서리점</translation>
    </message>
    <message>
        <source>the rounding</source>
        <translation>둥글기</translation>
    </message>
    <message>
        <source>the size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>the width</source>
        <translation>너비</translation>
    </message>
    <message>
        <source>the height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>반지름</translation>
    </message>
    <message>
        <source>the outer radius</source>
        <translation>바깥 반지름</translation>
    </message>
    <message>
        <source>the inner radius</source>
        <translation>안쪽 반지름</translation>
    </message>
    <message>
        <source>the first half-axis</source>
        <translation>첫째 반축</translation>
    </message>
    <message>
        <source>the second half-axis</source>
        <translation>둘째 반축</translation>
    </message>
</context>
<context>
    <name>blossom::modeling::MoveTool</name>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Moved by %1 · Ctrl: no steps · Esc takes it back</source>
        <translation>%1만큼 이동 · Ctrl: 단계 없이 · Esc: 되돌리기</translation>
    </message>
    <message>
        <source>Drag an arrow to move the shape along an axis, the point to move it above the ground</source>
        <translation>화살표를 끌면 축을 따라, 점을 끌면 바닥 위에서 도형이 이동합니다</translation>
    </message>
    <message>
        <source>Drag: move it parallel to the ground</source>
        <translation>끌기: 바닥과 나란히 이동</translation>
    </message>
    <message>
        <source>Drag: move it along the arrow</source>
        <translation>끌기: 화살표를 따라 이동</translation>
    </message>
</context>
<context>
    <name>blossom::morphology::RadiusTool</name>
    <message>
        <source>Drag the radius</source>
        <translation>반지름 끌기</translation>
    </message>
    <message>
        <source>The radius is %1 · Ctrl: no steps · Esc takes it back</source>
        <translation>반지름 %1 · Ctrl: 단계 없이 · Esc: 되돌리기</translation>
    </message>
    <message>
        <source>Drag up or down to change the radius of %1</source>
        <translation>위아래로 끌어 반지름 %1 바꾸기</translation>
    </message>
    <message>
        <source>Drag the handle to change the radius</source>
        <translation>손잡이를 끌어 반지름 바꾸기</translation>
    </message>
</context>
<context>
    <name>blossom::morphology::SumOverlay</name>
    <message>
        <source>corner + face</source>
        <translation>꼭짓점 + 면</translation>
    </message>
    <message>
        <source>face + corner</source>
        <translation>면 + 꼭짓점</translation>
    </message>
    <message>
        <source>edge + edge</source>
        <translation>모서리 + 모서리</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::CurveTool</name>
    <message>
        <source>Pull a point</source>
        <translation>점 당기기</translation>
    </message>
    <message>
        <source>Let go to pull the curve here · Esc takes it back</source>
        <translation>놓으면 곡선이 여기로 당겨집니다 · Esc는 되돌립니다</translation>
    </message>
    <message>
        <source>Drag to pull this point of the curve</source>
        <translation>드래그하면 곡선의 이 점을 당깁니다</translation>
    </message>
    <message>
        <source>Drag a place near a control point to pull the smooth curve there</source>
        <translation>제어점 근처를 드래그하면 매끄러운 곡선이 그곳으로 당겨집니다</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::PullTool</name>
    <message>
        <source>Pull a point</source>
        <translation>점 당기기</translation>
    </message>
    <message>
        <source>Let go to pull the point here · Shift: along the normal · Esc takes it back</source>
        <translation>놓으면 점을 여기로 당김 · Shift: 법선 방향 · Esc로 취소</translation>
    </message>
    <message>
        <source>Drag to pull this point of the surface</source>
        <translation>끌어서 곡면의 이 점을 당기기</translation>
    </message>
    <message>
        <source>Drag a place over a vertex of the cage to pull the smooth surface there</source>
        <translation>케이지 꼭짓점 위의 자리를 끌어 매끄러운 곡면 당기기</translation>
    </message>
</context>
<context>
    <name>blossom::subdivision::StrokeTool</name>
    <message>
        <source>Pull to a stroke</source>
        <translation>획으로 당기기</translation>
    </message>
    <message>
        <source>Draw a stroke</source>
        <translation>획 그리기</translation>
    </message>
    <message>
        <source>Click or draw where the shape is to run</source>
        <translation>도형이 지나갈 곳을 클릭하거나 그리기</translation>
    </message>
    <message>
        <source>Click or draw the stroke</source>
        <translation>획을 클릭하거나 그리기</translation>
    </message>
    <message>
        <source>Click the next point, or drag to draw</source>
        <translation>다음 점을 클릭하거나 끌어서 그리기</translation>
    </message>
    <message>
        <source>X, Y, Z: the plane across that axis</source>
        <translation>X, Y, Z: 그 축에 수직인 평면</translation>
    </message>
    <message>
        <source>Backspace takes back</source>
        <translation>백스페이스로 되돌리기</translation>
    </message>
    <message>
        <source>Enter pulls the shape to it</source>
        <translation>Enter로 도형을 당기기</translation>
    </message>
    <message>
        <source>Enter finishes</source>
        <translation>Enter로 마치기</translation>
    </message>
    <message>
        <source>Esc leaves</source>
        <translation>Esc로 나가기</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorNet</name>
    <message>
        <source>Poles over the (u, v) domain</source>
        <translation>(u, v) 영역의 제어점</translation>
    </message>
    <message>
        <source>Click to insert a knot at %1 = %2</source>
        <translation>클릭하면 %1 = %2에 매듭을 넣습니다</translation>
    </message>
    <message>
        <source>Click a pole to choose it, drag a frame around several · click in the margin to insert a knot</source>
        <translation>제어점을 클릭하여 고르고, 상자를 끌어 여러 개 고르기 · 가장자리를 클릭하면 매듭을 넣음</translation>
    </message>
    <message>
        <source>Drag to the right or left to turn the pole about the axis · Ctrl: choose several</source>
        <translation>좌우로 끌어 제어점을 축 둘레로 회전 · Ctrl: 여러 개 고르기</translation>
    </message>
    <message>
        <source>Drag up or down to scale the pole · Ctrl: choose several</source>
        <translation>위아래로 끌어 제어점의 크기 조절 · Ctrl: 여러 개 고르기</translation>
    </message>
    <message>
        <source>Drag up or down to change the weight of the pole · Ctrl: choose several</source>
        <translation>위아래로 끌어 제어점의 가중치 바꾸기 · Ctrl: 여러 개 고르기</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorsPanel</name>
    <message>
        <source>Turn</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>지정</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>좌표계</translation>
    </message>
    <message>
        <source>Draw the frames M(u, v) along u and v</source>
        <translation>u와 v를 따라 좌표계 M(u, v) 그리기</translation>
    </message>
    <message>
        <source>Iso-curves</source>
        <translation>아이소커브</translation>
    </message>
    <message>
        <source>Draw the curves of constant u and v at the knots</source>
        <translation>매듭에서 u와 v가 일정한 곡선 그리기</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>곡률 빗</translation>
    </message>
    <message>
        <source>Draw the curvature comb of the trajectory</source>
        <translation>궤적의 곡률 빗 그리기</translation>
    </message>
    <message>
        <source>Factors</source>
        <translation>인자</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>궤적</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Scaling</source>
        <translation>크기 조절</translation>
    </message>
    <message>
        <source>Edit the poles of this factor</source>
        <translation>이 인자의 제어점 편집</translation>
    </message>
    <message>
        <source>Turn the chosen poles about the axis by the angle</source>
        <translation>고른 제어점을 축 둘레로 각도만큼 회전</translation>
    </message>
    <message>
        <source>Give the chosen poles this turn from the fixed axes</source>
        <translation>고른 제어점에 고정 축 기준으로 이 회전을 지정</translation>
    </message>
    <message>
        <source>Along u</source>
        <translation>u 방향</translation>
    </message>
    <message>
        <source>The comb along u through the chosen pole</source>
        <translation>고른 제어점을 지나는 u 방향 곡률 빗</translation>
    </message>
    <message>
        <source>Along v</source>
        <translation>v 방향</translation>
    </message>
    <message>
        <source>The comb along v through the chosen pole</source>
        <translation>고른 제어점을 지나는 v 방향 곡률 빗</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>가중치</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>축 %1</translation>
    </message>
    <message>
        <source>A drag in the net scales along this axis</source>
        <translation>망에서 끌면 이 축 방향으로 크기를 조절합니다</translation>
    </message>
    <message>
        <source>Close the card</source>
        <translation>카드 닫기</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::FactorsTool</name>
    <message>
        <source>Move poles of the trajectory</source>
        <translation>궤적의 제어점 이동</translation>
    </message>
    <message>
        <source>Insert a knot</source>
        <translation>매듭 넣기</translation>
    </message>
    <message>
        <source>No pole is chosen</source>
        <translation>고른 제어점 없음</translation>
    </message>
    <message>
        <source>%1 poles</source>
        <translation>제어점 %1개</translation>
    </message>
    <message>
        <source>Pole %1 · reaches %2</source>
        <translation>제어점 %1 · 영향 범위 %2</translation>
    </message>
    <message>
        <source>Pole (%1, %2) · reaches %3, %4</source>
        <translation>제어점 (%1, %2) · 영향 범위 %3, %4</translation>
    </message>
    <message>
        <source>along u at v = %1</source>
        <translation>u 방향, v = %1</translation>
    </message>
    <message>
        <source>along v at u = %1</source>
        <translation>v 방향, u = %1</translation>
    </message>
    <message>
        <source>Curvature along v, 1/mm</source>
        <translation>v 방향 곡률, 1/mm</translation>
    </message>
    <message>
        <source>Angular velocity, ° per range, %1</source>
        <translation>각속도, 구간당 °, %1</translation>
    </message>
    <message>
        <source>Factors with curvature, %1</source>
        <translation>인자와 곡률, %1</translation>
    </message>
    <message>
        <source>Let go to turn by %1° · Esc takes it back</source>
        <translation>놓으면 %1° 회전 · Esc로 취소</translation>
    </message>
    <message>
        <source>Let go to multiply the weight by %1 · Esc takes it back</source>
        <translation>놓으면 가중치에 %1을(를) 곱함 · Esc로 취소</translation>
    </message>
    <message>
        <source>Let go to scale by %1 · Esc takes it back</source>
        <translation>놓으면 크기를 %1배로 조절 · Esc로 취소</translation>
    </message>
    <message>
        <source>Turn poles of the orientation</source>
        <translation>자세의 제어점 회전</translation>
    </message>
    <message>
        <source>Scale poles</source>
        <translation>제어점 크기 조절</translation>
    </message>
    <message>
        <source>Change weights of the trajectory</source>
        <translation>궤적의 가중치 변경</translation>
    </message>
    <message>
        <source>The motion is being prepared</source>
        <translation>운동을 준비하는 중</translation>
    </message>
    <message>
        <source>Nothing will be changed here: %1</source>
        <translation>여기서는 아무것도 바뀌지 않음: %1</translation>
    </message>
    <message>
        <source>Let go to move the pole here · Esc takes it back</source>
        <translation>놓으면 제어점을 여기로 이동 · Esc로 취소</translation>
    </message>
    <message>
        <source>Drag to move the pole along %1</source>
        <translation>끌어서 제어점을 %1 방향으로 이동</translation>
    </message>
    <message>
        <source>Drag to move the pole in the plane of the view · Shift: choose several · Alt: turn the view</source>
        <translation>끌어서 제어점을 보기 평면에서 이동 · Shift: 여러 개 고르기 · Alt: 보기 회전</translation>
    </message>
    <message>
        <source>Drag a pole of the trajectory, or choose one to move it along an axis</source>
        <translation>궤적의 제어점을 끌거나, 하나를 골라 축 방향으로 이동</translation>
    </message>
    <message>
        <source>Choose poles in the net and drag them there</source>
        <translation>망에서 제어점을 골라 거기서 끌기</translation>
    </message>
    <message>
        <source>%1, the first pole</source>
        <translation>%1, 첫 제어점</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::GoalEntry</name>
    <message>
        <source>A target has three coordinates: x, y, z. One that is left empty stays, as in &quot;0, -20,&quot;.</source>
        <translation>목표에는 좌표가 셋 있어야 합니다: x, y, z. &quot;0, -20,&quot;처럼 비워 둔 좌표는 그대로입니다.</translation>
    </message>
    <message>
        <source>%1 coordinates were typed; a target has three: x, y, z.</source>
        <translation>좌표를 %1개 입력했습니다. 목표에는 좌표가 셋 있습니다: x, y, z.</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::PullMode</name>
    <message>
        <source>by turning and scaling</source>
        <translation>회전과 크기 조절로</translation>
    </message>
    <message>
        <source>by moving the sections</source>
        <translation>단면 이동으로</translation>
    </message>
    <message>
        <source>by turning alone</source>
        <translation>회전만으로</translation>
    </message>
    <message>
        <source>by scaling alone</source>
        <translation>크기 조절만으로</translation>
    </message>
    <message>
        <source>by twisting</source>
        <translation>비틀어서</translation>
    </message>
    <message>
        <source>the tangent of the trajectory</source>
        <translation>궤적의 접선</translation>
    </message>
    <message>
        <source>the arm from the trajectory to the point</source>
        <translation>궤적에서 점까지의 팔</translation>
    </message>
    <message>
        <source>the axis across tangent and arm</source>
        <translation>접선과 팔에 수직인 축</translation>
    </message>
    <message>
        <source>%1 copies, mirrored</source>
        <translation>사본 %1개, 대칭</translation>
    </message>
    <message>
        <source>%1 copies</source>
        <translation>사본 %1개</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>대칭</translation>
    </message>
    <message>
        <source>one level finer</source>
        <translation>한 단계 세밀하게</translation>
    </message>
    <message>
        <source>one level coarser</source>
        <translation>한 단계 성기게</translation>
    </message>
    <message>
        <source>%1 levels finer</source>
        <translation>%1단계 세밀하게</translation>
    </message>
    <message>
        <source>%1 levels coarser</source>
        <translation>%1단계 성기게</translation>
    </message>
    <message>
        <source>by %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>크기 변경</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::SurfacePullTool</name>
    <message>
        <source>Twist the surface</source>
        <translation>곡면 비틀기</translation>
    </message>
    <message>
        <source>Pull the surface</source>
        <translation>곡면 당기기</translation>
    </message>
    <message>
        <source>Drag a place on the surface to pull it</source>
        <translation>곡면의 한 곳을 끌어서 당기기</translation>
    </message>
    <message>
        <source>Drag a place on the surface to twist it</source>
        <translation>곡면의 한 곳을 끌어서 비틀기</translation>
    </message>
    <message>
        <source>Nothing will be changed here: %1</source>
        <translation>여기서는 아무것도 바뀌지 않음: %1</translation>
    </message>
    <message>
        <source>Let go to twist by %1° about %2</source>
        <translation>놓으면 %2 둘레로 %1° 비틂</translation>
    </message>
    <message>
        <source>A: another axis</source>
        <translation>A: 다른 축</translation>
    </message>
    <message>
        <source>Let go to pull the point here %1</source>
        <translation>놓으면 점을 여기로 당김, %1</translation>
    </message>
    <message>
        <source>Shift: along the normal</source>
        <translation>Shift: 법선 방향</translation>
    </message>
    <message>
        <source>Esc takes it back</source>
        <translation>Esc로 취소</translation>
    </message>
    <message>
        <source>1: no copies</source>
        <translation>1: 사본 없음</translation>
    </message>
    <message>
        <source>Drag to twist the surface here about %1</source>
        <translation>끌어서 %1 둘레로 여기 곡면을 비틀기</translation>
    </message>
    <message>
        <source>W: pull</source>
        <translation>W: 당기기</translation>
    </message>
    <message>
        <source>Drag to change the selected edit here; those after it are hidden meanwhile</source>
        <translation>끌어서 선택한 편집을 여기서 바꾸기; 그 뒤의 편집은 그동안 숨김</translation>
    </message>
    <message>
        <source>Enter: type its goal</source>
        <translation>Enter: 목표 입력</translation>
    </message>
    <message>
        <source>The surface of the selected edit is being prepared</source>
        <translation>선택한 편집의 곡면을 준비하는 중</translation>
    </message>
    <message>
        <source>Let go to twist by %1° in the selected edit</source>
        <translation>놓으면 선택한 편집에서 %1° 비틀기</translation>
    </message>
    <message>
        <source>Let go to pull the point here in the selected edit</source>
        <translation>놓으면 선택한 편집에서 점을 여기로 당기기</translation>
    </message>
    <message>
        <source>Drag to pull further, %1</source>
        <translation>끌어서 더 당기기, %1</translation>
    </message>
    <message>
        <source>Drag to pull %1</source>
        <translation>끌어서 당기기, %1</translation>
    </message>
    <message>
        <source>W: twist</source>
        <translation>W: 비틀기</translation>
    </message>
    <message>
        <source>2–9, M: copies</source>
        <translation>2–9, M: 사본</translation>
    </message>
    <message>
        <source>%1 (1: none)</source>
        <translation>%1 (1: 없음)</translation>
    </message>
    <message>
        <source>Type the angle of the twist · Enter takes it · Esc leaves it as it is</source>
        <translation>비틀 각도 입력 · Enter: 적용 · Esc: 그대로 두기</translation>
    </message>
    <message>
        <source>Type where the point goes: x, y, z · Enter takes it · Esc leaves it as it is</source>
        <translation>점이 갈 곳 입력: x, y, z · Enter: 적용 · Esc: 그대로 두기</translation>
    </message>
    <message>
        <source>Poles move %1 times as far: places and pins are too near each other</source>
        <translation>극점이 %1배 멀리 움직임: 자리와 고정점이 서로 너무 가까움</translation>
    </message>
    <message>
        <source>The places cannot all arrive; %1 is left at most</source>
        <translation>모든 자리가 도달할 수는 없음. 남는 거리는 최대 %1</translation>
    </message>
    <message>
        <source>Enter: type the angle</source>
        <translation>Enter: 각도 입력</translation>
    </message>
    <message>
        <source>Enter: type the target</source>
        <translation>Enter: 목표 입력</translation>
    </message>
    <message>
        <source>Shift-click: take along</source>
        <translation>Shift+클릭: 함께</translation>
    </message>
    <message>
        <source>P: pin it</source>
        <translation>P: 고정</translation>
    </message>
    <message>
        <source>chosen: %1, pinned: %2 (Esc: none)</source>
        <translation>고름: %1, 고정: %2 (Esc: 없음)</translation>
    </message>
    <message>
        <source>+, −: finer, coarser</source>
        <translation>+, −: 세밀하게, 성기게</translation>
    </message>
    <message>
        <source>%1 (0: as it is)</source>
        <translation>%1 (0: 그대로)</translation>
    </message>
    <message>
        <source>No sweep is made of this motion: choose Sweep to see its surface and pull it</source>
        <translation>이 움직임으로 만든 스윕이 없습니다: 스윕을 선택하면 곡면을 보고 당길 수 있습니다</translation>
    </message>
    <message>
        <source>Let go to pull %1 places %2</source>
        <translation>놓으면 %1곳을 당깁니다, %2</translation>
    </message>
    <message>
        <source>Let go to twist %1 places by %2° about %3</source>
        <translation>놓으면 %1곳을 %3 둘레로 %2° 비틉니다</translation>
    </message>
    <message>
        <source>%1 pinned</source>
        <translation>%1곳 고정</translation>
    </message>
    <message>
        <source>wheel: share of %1</source>
        <translation>휠: %1의 비율</translation>
    </message>
    <message>
        <source>Shift+wheel: share of %1</source>
        <translation>Shift+휠: %1의 비율</translation>
    </message>
    <message>
        <source>T, R, S: one alone (Shift: as well)</source>
        <translation>T, R, S: 한 방식만 (Shift: 함께)</translation>
    </message>
    <message>
        <source>Let go to twist about this axis</source>
        <translation>놓으면 이 축을 중심으로 비틉니다</translation>
    </message>
    <message>
        <source>Shift: along x, y, z, the tangent, the arm or across both</source>
        <translation>Shift: x, y, z, 접선, 팔 또는 그 둘에 수직인 방향</translation>
    </message>
    <message>
        <source>Drag to turn the axis of this twist</source>
        <translation>끌어서 이 비틀기의 축을 돌립니다</translation>
    </message>
    <message>
        <source>Turn the axis of a twist</source>
        <translation>비틀기의 축 돌리기</translation>
    </message>
    <message>
        <source>selected edit: %1</source>
        <translation>선택한 편집: %1</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::TurnBall</name>
    <message>
        <source>Trackball</source>
        <translation>트랙볼</translation>
    </message>
    <message>
        <source>Drag to turn the chosen poles as the view sees them; along the rim, about the line of sight</source>
        <translation>끌면 고른 제어점을 보기에 보이는 대로 회전, 가장자리를 따라 끌면 시선 둘레로 회전</translation>
    </message>
</context>
<context>
    <name>blossom::sweep::ValidityMarks</name>
    <message>
        <source>smallest normal</source>
        <translation>가장 작은 법선</translation>
    </message>
    <message>
        <source>smallest weight</source>
        <translation>가장 작은 가중치</translation>
    </message>
    <message>
        <source>crosses itself</source>
        <translation>자기 교차</translation>
    </message>
</context>
<context>
    <name>blossom::ui::AboutDialog</name>
    <message>
        <source>The text of the licence is not installed. It can be read at https://www.gnu.org/licenses/gpl-3.0.txt.</source>
        <translation>라이선스 본문이 설치되어 있지 않습니다. https://www.gnu.org/licenses/gpl-3.0.txt 에서 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>About Blossom</source>
        <translation>Blossom 정보</translation>
    </message>
    <message>
        <source>&amp;Copy versions</source>
        <translation>버전 복사(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Licence</source>
        <translation>라이선스(&amp;L)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Blossom %1</source>
        <translation>Blossom %1</translation>
    </message>
    <message>
        <source>A workbench for shapes that morph, sweep, grow and melt.
Free software under the GNU General Public License, version 3 or later.</source>
        <translation>변형되고, 쓸고 지나가고, 자라고 녹는 형상을 위한 작업대입니다.
GNU 일반 공중 사용 허가서 3판 이상을 따르는 자유 소프트웨어입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Chip</name>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ChoiceField</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>꼭 지정해야 함</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ChooseTool</name>
    <message>
        <source>Esc ends</source>
        <translation>Esc로 끝내기</translation>
    </message>
    <message>
        <source>%1: click it in the view or in the document; Esc ends</source>
        <translation>%1: 보기나 문서에서 클릭하십시오. Esc로 끝냅니다</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ColorField</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>꼭 지정해야 함</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>명령 찾기</translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature, a page of the manual</source>
        <translation>명령, 예제, 피처, 설명서 쪽 찾기</translation>
    </message>
    <message>
        <source>Nothing is called &quot;%1&quot;.</source>
        <translation>&quot;%1&quot;이라는 것이 없습니다.</translation>
    </message>
    <message>
        <source>Return or click: %1 · Up and down: choose · Esc: close</source>
        <translation>Enter 또는 클릭: %1 · 위아래: 고르기 · Esc: 닫기</translation>
    </message>
    <message>
        <source>%1 cannot be done now. %2</source>
        <translation>지금은 %1을(를) 할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>최근</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>설명서</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurvatureLegend</name>
    <message>
        <source>Gaussian curvature</source>
        <translation>가우스 곡률</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>평균 곡률</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>최대 곡률</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveEditor</name>
    <message>
        <source>Click to add a point, drag to move it, right click or Delete to remove it</source>
        <translation>클릭: 점 추가, 끌기: 이동, 오른쪽 클릭 또는 Delete: 제거</translation>
    </message>
    <message>
        <source>click to add a point</source>
        <translation>클릭하여 점 추가</translation>
    </message>
</context>
<context>
    <name>blossom::ui::CurveField</name>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>t of the chosen point</source>
        <translation>고른 점의 t</translation>
    </message>
    <message>
        <source>value of the chosen point</source>
        <translation>고른 점의 값</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> 이전 값을 유지합니다.</translation>
    </message>
    <message>
        <source>Remove all points</source>
        <translation>모든 점 제거</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentClosing</name>
    <message>
        <source>%1 (sample, untitled)</source>
        <translation>%1 (예제, 제목 없음)</translation>
    </message>
    <message>
        <source>%1 (untitled)</source>
        <translation>%1 (제목 없음)</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>%1의 변경을 저장하겠습니까?</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>저장하지 않으면 사라집니다.</translation>
    </message>
    <message>
        <source>%1, tab %2</source>
        <translation>%1, 탭 %2</translation>
    </message>
    <message>
        <source>%1 is still being written; it is closed then.</source>
        <translation>%1을(를) 아직 쓰는 중입니다. 다 쓰면 닫습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentCommands</name>
    <message>
        <source>Recomp&amp;ute</source>
        <translation>다시 계산(&amp;U)</translation>
    </message>
    <message>
        <source>Compute every feature anew, also those whose results are known.</source>
        <translation>결과를 이미 아는 것까지 모든 피처를 다시 계산합니다.</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>편집</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation>마지막 변경을 되돌립니다.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>다시 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Do again what was taken back.</source>
        <translation>되돌린 것을 다시 실행합니다.</translation>
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
        <translation>잘라내기(&amp;T)</translation>
    </message>
    <message>
        <source>Take the selected features out, to be pasted elsewhere.</source>
        <translation>고른 피처를 떼어 내어 다른 곳에 붙여넣을 수 있게 합니다.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>복사(&amp;C)</translation>
    </message>
    <message>
        <source>Keep the selected features, and what they are made from, to be pasted.</source>
        <translation>고른 피처와 그 재료를 붙여넣을 수 있게 기억합니다.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>붙여넣기(&amp;P)</translation>
    </message>
    <message>
        <source>Add the features that were copied, in this document or another.</source>
        <translation>복사한 피처를 이 문서나 다른 문서에 추가합니다.</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>복제(&amp;D)</translation>
    </message>
    <message>
        <source>Add the selected features once more, made from the same inputs.</source>
        <translation>고른 피처를 같은 입력으로 한 번 더 추가합니다.</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>이름 바꾸기(&amp;N)</translation>
    </message>
    <message>
        <source>Give the selected feature another name.</source>
        <translation>고른 피처의 이름을 바꿉니다.</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Show or &amp;hide</source>
        <translation>보이기/숨기기(&amp;H)</translation>
    </message>
    <message>
        <source>Show or hide the selected features.</source>
        <translation>고른 피처를 보이거나 숨깁니다.</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>분리해서 보기(&amp;I)</translation>
    </message>
    <message>
        <source>Show only the selected features; once more: what was shown before.</source>
        <translation>고른 피처만 보입니다. 다시 누르면 이전 상태로 돌아갑니다.</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Sho&amp;w everything</source>
        <translation>모두 보이기(&amp;W)</translation>
    </message>
    <message>
        <source>Show every feature.</source>
        <translation>모든 피처를 보입니다.</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Suppress</source>
        <translation>계산 제외(&amp;S)</translation>
    </message>
    <message>
        <source>Leave the selected features out of the computation, or take them in again.</source>
        <translation>고른 피처를 계산에서 빼거나 다시 넣습니다.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+U</source>
        <translation>Ctrl+Shift+U</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>위로(&amp;U)</translation>
    </message>
    <message>
        <source>Put the selected features one place further up; edits that follow one another change places.</source>
        <translation>고른 피처를 한 칸 위로 옮깁니다. 잇따르는 편집은 자리를 바꿉니다.</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>아래로(&amp;W)</translation>
    </message>
    <message>
        <source>Put the selected features one place further down; edits that follow one another change places.</source>
        <translation>고른 피처를 한 칸 아래로 옮깁니다. 잇따르는 편집은 자리를 바꿉니다.</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Down</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>삭제(&amp;L)</translation>
    </message>
    <message>
        <source>Delete the selected features.</source>
        <translation>고른 피처를 삭제합니다.</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>모두 선택(&amp;A)</translation>
    </message>
    <message>
        <source>Select every feature.</source>
        <translation>모든 피처를 선택합니다.</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>선택 해제(&amp;O)</translation>
    </message>
    <message>
        <source>Select no feature.</source>
        <translation>아무 피처도 선택하지 않습니다.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Find in the document</source>
        <translation>문서에서 찾기(&amp;F)</translation>
    </message>
    <message>
        <source>Look for features by name, type or state.</source>
        <translation>이름, 종류, 상태로 피처를 찾습니다.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>Fit to &amp;selection</source>
        <translation>선택에 맞추기(&amp;S)</translation>
    </message>
    <message>
        <source>Show just the selected features, as large as fits.</source>
        <translation>고른 피처만 가능한 한 크게 보입니다.</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>실행 취소(&amp;U): %1</translation>
    </message>
    <message>
        <source>Nothing has been changed yet.</source>
        <translation>아직 바뀐 것이 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>다시 실행(&amp;R): %1</translation>
    </message>
    <message>
        <source>Nothing was taken back.</source>
        <translation>되돌린 것이 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>숨기기(&amp;H)</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>보이기(&amp;H)</translation>
    </message>
    <message>
        <source>Compute a&amp;gain</source>
        <translation>다시 계산(&amp;G)</translation>
    </message>
    <message>
        <source>End &amp;isolation</source>
        <translation>분리 끝내기(&amp;I)</translation>
    </message>
    <message>
        <source>Select a feature first.</source>
        <translation>먼저 피처를 고르십시오.</translation>
    </message>
    <message>
        <source>Select one feature only.</source>
        <translation>피처를 하나만 고르십시오.</translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation>문서가 비어 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Make from it</source>
        <translation>이것으로 만들기(&amp;M)</translation>
    </message>
    <message>
        <source>Named &amp;numbers…</source>
        <translation>이름 붙은 수(&amp;N)…</translation>
    </message>
    <message>
        <source>Numbers with names that every field can use.</source>
        <translation>모든 입력란에서 쓸 수 있는, 이름 붙은 수입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentExport</name>
    <message>
        <source>Replace %1?</source>
        <translation>%1을(를) 바꿀까요?</translation>
    </message>
    <message>
        <source>Replace %1 files, %2 to %3?</source>
        <translation>파일 %1개(%2부터 %3까지)를 바꿀까요?</translation>
    </message>
    <message>
        <source>Each frame of the sequence is a file of its own, and these are there already.</source>
        <translation>시퀀스의 각 프레임은 따로 된 파일이며, 이 파일들은 이미 있습니다.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
    <message>
        <source>The %1 selected results as one file</source>
        <translation>고른 결과 %1개를 한 파일로</translation>
    </message>
    <message>
        <source>All %1 visible results as one file</source>
        <translation>보이는 결과 %1개를 한 파일로</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>A sequence is exported alone.</source>
        <translation>시퀀스는 따로 내보냅니다.</translation>
    </message>
    <message>
        <source>Select the sequence or the shapes, not both.</source>
        <translation>시퀀스와 형상 중 하나만 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentFiles</name>
    <message>
        <source>Blossom documents (*.blossom)</source>
        <translation>Blossom 문서 (*.blossom)</translation>
    </message>
    <message>
        <source>%1 is not there.</source>
        <translation>%1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>%1 has no extension that Blossom reads.</source>
        <translation>%1의 확장자는 Blossom이 읽지 못합니다.</translation>
    </message>
    <message>
        <source>%1 of %2 files cannot be opened.</source>
        <translation>파일 %2개 가운데 %1개를 열 수 없습니다.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1이(가) 다른 프로그램에서 바뀌었습니다.</translation>
    </message>
    <message>
        <source>Since it was opened here, somebody else has written it. Saving replaces what they wrote.</source>
        <translation>여기서 연 뒤에 다른 곳에서 그 파일을 썼습니다. 저장하면 그 내용을 덮어씁니다.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>다른 이름으로 저장</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1이(가) 이미 있습니다.</translation>
    </message>
    <message>
        <source>Saving replaces it.</source>
        <translation>저장하면 덮어씁니다.</translation>
    </message>
    <message>
        <source>%1 is a folder. Open the files in it instead.</source>
        <translation>%1은(는) 폴더입니다. 그 안의 파일을 여십시오.</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>열 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentModel</name>
    <message>
        <source>suppressed</source>
        <translation>계산에서 제외됨</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>계산 중…</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>계산하지 않음</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 이름 바꾸기</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>취소됨</translation>
    </message>
    <message>
        <source>Compute it in its properties.</source>
        <translation>속성에서 계산할 수 있습니다.</translation>
    </message>
    <message>
        <source>a step warns · %1</source>
        <translation>단계에 경고 있음 · %1</translation>
    </message>
    <message>
        <source>Unfold it to see which.</source>
        <translation>펼치면 어느 단계인지 보입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentPage</name>
    <message>
        <source>Computing</source>
        <translation>계산 중</translation>
    </message>
    <message>
        <source>The file was written; look at this before you use it.</source>
        <translation>파일을 저장했습니다. 사용하기 전에 다음을 확인하십시오.</translation>
    </message>
    <message>
        <source>Not everything could be read.</source>
        <translation>읽지 못한 것이 있습니다.</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>작업 중</translation>
    </message>
    <message>
        <source>The handles of %1 cannot be shown.</source>
        <translation>%1의 손잡이를 표시할 수 없습니다.</translation>
    </message>
    <message>
        <source>Open what is readable</source>
        <translation>읽을 수 있는 것 열기</translation>
    </message>
    <message>
        <source>This document names files outside its folder. They were not read.</source>
        <translation>이 문서는 폴더 밖의 파일을 가리킵니다. 그 파일은 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>Read them</source>
        <translation>읽기</translation>
    </message>
    <message>
        <source>Computing was cancelled.</source>
        <translation>계산이 취소되었습니다.</translation>
    </message>
    <message>
        <source>What was ready is shown.</source>
        <translation>준비된 결과를 표시합니다.</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>계산</translation>
    </message>
    <message>
        <source>Play %1</source>
        <translation>%1 재생</translation>
    </message>
    <message>
        <source>Looking at the surfaces</source>
        <translation>곡면 살펴보는 중</translation>
    </message>
    <message>
        <source>Move a key of %1</source>
        <translation>%1의 키 옮기기</translation>
    </message>
    <message>
        <source>Set a key of %1</source>
        <translation>%1의 키 설정</translation>
    </message>
    <message>
        <source>Remove a key of %1</source>
        <translation>%1의 키 지우기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTabs</name>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Close others</source>
        <translation>나머지 닫기</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>폴더에서 보기</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>경로 복사</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTree</name>
    <message>
        <source>Document</source>
        <translation>문서</translation>
    </message>
    <message>
        <source>error failed</source>
        <translation>오류 실패</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>경고</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>숨김</translation>
    </message>
    <message>
        <source>Click: hide %1</source>
        <translation>클릭: %1 숨기기</translation>
    </message>
    <message>
        <source>Click: show %1</source>
        <translation>클릭: %1 보이기</translation>
    </message>
    <message>
        <source>%1 · Click: select · Ctrl+click: select more · Double click: rename · Drag: reorder · Right click: more</source>
        <translation>%1 · 클릭: 선택 · Ctrl+클릭: 추가 선택 · 두 번 클릭: 이름 바꾸기 · 끌기: 순서 바꾸기 · 오른쪽 클릭: 더 보기</translation>
    </message>
    <message>
        <source>Release: move here</source>
        <translation>놓기: 여기로 이동</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 보이기</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 숨기기</translation>
    </message>
    <message>
        <source>Show %1 features</source>
        <translation>피처 %1개 보이기</translation>
    </message>
    <message>
        <source>Hide %1 features</source>
        <translation>피처 %1개 숨기기</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>모두 보이기</translation>
    </message>
    <message>
        <source>End isolation</source>
        <translation>분리 끝내기</translation>
    </message>
    <message>
        <source>Isolate %1</source>
        <translation>%1 분리해서 보기</translation>
    </message>
    <message>
        <source>Isolate %1 features</source>
        <translation>피처 %1개 분리해서 보기</translation>
    </message>
    <message>
        <source>Suppress %1</source>
        <translation>%1 계산 제외</translation>
    </message>
    <message>
        <source>Suppress %1 features</source>
        <translation>피처 %1개 계산 제외</translation>
    </message>
    <message>
        <source>Compute %1 again</source>
        <translation>%1 다시 계산</translation>
    </message>
    <message>
        <source>Compute %1 features again</source>
        <translation>피처 %1개 다시 계산</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 삭제</translation>
    </message>
    <message>
        <source>Delete %1 features</source>
        <translation>피처 %1개 삭제</translation>
    </message>
    <message>
        <source> and %1</source>
        <translation> 및 %1</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>고른 것</translation>
    </message>
    <message>
        <source>Delete that too, or suppress: what is suppressed stays but is not computed.</source>
        <translation>그것도 삭제하거나 계산에서 제외하십시오. 제외한 것은 남지만 계산하지 않습니다.</translation>
    </message>
    <message>
        <source>Delete them too, or suppress: what is suppressed stays but is not computed.</source>
        <translation>그것들도 삭제하거나 계산에서 제외하십시오. 제외한 것은 남지만 계산하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 is used by %2.</source>
        <translation>%1은(는) %2에서 쓰입니다.</translation>
    </message>
    <message>
        <source>Delete alone</source>
        <translation>이것만 삭제</translation>
    </message>
    <message>
        <source>Delete all %1</source>
        <translation>%1개 모두 삭제</translation>
    </message>
    <message>
        <source>Suppress</source>
        <translation>계산 제외</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>Move %1 features</source>
        <translation>피처 %1개 이동</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 붙여넣기</translation>
    </message>
    <message>
        <source>Paste %1 features</source>
        <translation>피처 %1개 붙여넣기</translation>
    </message>
    <message>
        <source>There are no features on the clipboard.</source>
        <translation>클립보드에 피처가 없습니다.</translation>
    </message>
    <message>
        <source>Select some and copy them first.</source>
        <translation>먼저 골라서 복사하십시오.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 복제</translation>
    </message>
    <message>
        <source>Duplicate %1 features</source>
        <translation>피처 %1개 복제</translation>
    </message>
    <message>
        <source>Click: show the steps of %1</source>
        <translation>클릭: %1의 단계 펼치기</translation>
    </message>
    <message>
        <source>Click: fold the steps of %1</source>
        <translation>클릭: %1의 단계 접기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::DocumentTreePanel</name>
    <message>
        <source>Name, type or state</source>
        <translation>이름, 종류, 상태</translation>
    </message>
    <message>
        <source>Find in the document</source>
        <translation>문서에서 찾기</translation>
    </message>
    <message>
        <source>DOCUMENT</source>
        <translation>문서</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ErrorBar</name>
    <message>
        <source>Dismiss (Esc)</source>
        <translation>닫기(Esc)</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ExportDialog</name>
    <message>
        <source>Shapes of these kinds do not go into one file.</source>
        <translation>이 종류의 형상들은 한 파일에 담을 수 없습니다.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
    <message>
        <source>What</source>
        <translation>대상</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>형식</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FaultBar</name>
    <message>
        <source>Show the feature</source>
        <translation>피처 보기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureHeader</name>
    <message>
        <source>Name of the feature</source>
        <translation>피처의 이름</translation>
    </message>
    <message>
        <source>Name of the feature; type another one</source>
        <translation>피처의 이름입니다. 다른 이름을 입력할 수 있습니다</translation>
    </message>
    <message>
        <source>Read about it in the manual</source>
        <translation>설명서에서 읽기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureMenus</name>
    <message>
        <source>Everything that can be read (%1)</source>
        <translation>읽을 수 있는 모든 파일 (%1)</translation>
    </message>
    <message>
        <source>Takes %1.</source>
        <translation>필요한 것: %1.</translation>
    </message>
    <message>
        <source>%1 takes %2 of the %3 selected shapes.</source>
        <translation>선택한 형상 %3개 중 %2개를 %1에 씁니다.</translation>
    </message>
    <message>
        <source>Left out: %1.</source>
        <translation>빠진 것: %1.</translation>
    </message>
    <message>
        <source>There is nothing here yet for %1: it takes %2.</source>
        <translation>%1에 쓸 것이 아직 없습니다. 필요한 것: %2.</translation>
    </message>
    <message>
        <source>There is too little here for %1, which takes %3 of these: %2.</source>
        <translation>%1에 쓸 것이 모자랍니다. 필요한 것: %2 %3개.</translation>
    </message>
    <message>
        <source>Draw or make one, or import a file.</source>
        <translation>그리거나 만들거나 파일을 가져오십시오.</translation>
    </message>
    <message>
        <source>Import a file…</source>
        <translation>파일 가져오기…</translation>
    </message>
    <message>
        <source>%1: choose a file with %2</source>
        <translation>%1: %2이(가) 든 파일 고르기</translation>
    </message>
    <message>
        <source>%1 takes nothing hidden: %2.</source>
        <translation>%1: 숨긴 것은 쓰지 않습니다: %2.</translation>
    </message>
    <message>
        <source>Show them first, or select in the tree what it is to take.</source>
        <translation>먼저 표시하거나, 쓸 것을 트리에서 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureStart</name>
    <message>
        <source>a shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>%1 선택</translation>
    </message>
    <message>
        <source>Choose %1 for %2</source>
        <translation>%2에 쓸 것을 고르십시오: %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%3개 중 %2번째)</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FeatureToolBar</name>
    <message>
        <source>Everything of %1</source>
        <translation>%1 전체</translation>
    </message>
    <message>
        <source>More</source>
        <translation>더 보기</translation>
    </message>
    <message>
        <source>The groups for which the window is too narrow</source>
        <translation>창이 좁아 들어가지 못한 그룹</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FileCommands</name>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the workbench.</source>
        <translation>작업대를 닫습니다.</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>새로 만들기(&amp;N)</translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation>빈 문서를 시작합니다.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Open documents, or geometry in new ones.</source>
        <translation>문서를 열거나 형상 파일을 새 문서로 엽니다.</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>최근 파일 열기(&amp;R)</translation>
    </message>
    <message>
        <source>Open a s&amp;ample</source>
        <translation>예제 열기(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;tart page</source>
        <translation>시작 화면(&amp;T)</translation>
    </message>
    <message>
        <source>Show samples and recent documents.</source>
        <translation>예제와 최근 문서를 보입니다.</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>가져오기(&amp;I)…</translation>
    </message>
    <message>
        <source>Add geometry from files to this document.</source>
        <translation>파일의 형상을 이 문서에 추가합니다.</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the selected results, or all that is visible, as STEP, STL, a picture, …</source>
        <translation>고른 결과나 보이는 모든 것을 STEP, STL, 그림 등으로 씁니다.</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Save this document.</source>
        <translation>이 문서를 저장합니다.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>다른 이름으로 저장(&amp;A)…</translation>
    </message>
    <message>
        <source>Save this document under another name.</source>
        <translation>이 문서를 다른 이름으로 저장합니다.</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Ne&amp;xt document</source>
        <translation>다음 문서(&amp;X)</translation>
    </message>
    <message>
        <source>Show the document in the next tab.</source>
        <translation>다음 탭의 문서를 보입니다.</translation>
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
        <translation>이전 문서(&amp;P)</translation>
    </message>
    <message>
        <source>Show the document in the tab before.</source>
        <translation>이전 탭의 문서를 보입니다.</translation>
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
        <translation>닫기(&amp;C)</translation>
    </message>
    <message>
        <source>Close this document.</source>
        <translation>이 문서를 닫습니다.</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Close ot&amp;hers</source>
        <translation>나머지 닫기(&amp;H)</translation>
    </message>
    <message>
        <source>Close every document but this one.</source>
        <translation>이 문서만 남기고 모두 닫습니다.</translation>
    </message>
    <message>
        <source>%1 (not there any more)</source>
        <translation>%1 (이제 없음)</translation>
    </message>
    <message>
        <source>Takes it off this list</source>
        <translation>목록에서 뺍니다</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>목록 비우기</translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation>문서가 비어 있습니다.</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved.</source>
        <translation>저장한 뒤로 바뀐 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FileField</name>
    <message>
        <source>Choose a file</source>
        <translation>파일 고르기</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>파일 고르기</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file of the type %2. The value before is kept.</source>
        <translation>&quot;%1&quot;은(는) %2 형식의 파일이 아닙니다. 이전 값을 유지합니다.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> 또는 </translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;. The value before is kept.</source>
        <translation>&quot;%1&quot; 파일이 없습니다. 이전 값을 유지합니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::FindField</name>
    <message>
        <source>Find a command</source>
        <translation>명령 찾기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::GuardedApplication</name>
    <message>
        <source>Blossom met a fault of its own: %1.</source>
        <translation>Blossom 내부 오류가 발생했습니다: %1.</translation>
    </message>
    <message>
        <source>What you did last may be undone. Save under another name and start Blossom anew.</source>
        <translation>마지막 작업은 실행 취소할 수 있습니다. 다른 이름으로 저장하고 Blossom을 다시 시작하십시오.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::HelpMenu</name>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>설명서(&amp;M)</translation>
    </message>
    <message>
        <source>Read how everything works.</source>
        <translation>사용법을 읽습니다.</translation>
    </message>
    <message>
        <source>About the &amp;selected feature</source>
        <translation>고른 피처에 대하여(&amp;S)</translation>
    </message>
    <message>
        <source>The manual&apos;s page of the selected feature: inputs, parameters, examples.</source>
        <translation>고른 피처의 설명서 쪽: 입력, 매개변수, 예제.</translation>
    </message>
    <message>
        <source>Shift+F1</source>
        <translation>Shift+F1</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>마우스와 단축키(&amp;K)</translation>
    </message>
    <message>
        <source>How to move around, and every key.</source>
        <translation>움직이는 방법과 모든 단축키입니다.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>둘러보기(&amp;T)</translation>
    </message>
    <message>
        <source>A walk through the window in four steps.</source>
        <translation>창을 네 단계로 둘러봅니다.</translation>
    </message>
    <message>
        <source>&amp;About Blossom</source>
        <translation>Blossom 정보(&amp;A)</translation>
    </message>
    <message>
        <source>Versions and licence.</source>
        <translation>버전과 라이선스입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::InputEditor</name>
    <message>
        <source>Add an input</source>
        <translation>입력 추가</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>보기에서 고르기</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>꼭 지정해야 함</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Nothing else fits here</source>
        <translation>여기에 맞는 것이 더 없습니다</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>아래로</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs this feature itself; taking it would go round in a circle.</source>
        <translation>&quot;%1&quot;은(는) 이 피처를 필요로 하므로 순환이 됩니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is %2, which does not fit here.</source>
        <translation>&quot;%1&quot;은(는) %2이므로 여기에 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%2의 %1 변경</translation>
    </message>
    <message>
        <source>Click what %1 is to be; Esc ends</source>
        <translation>%1(으)로 쓸 것을 클릭하십시오. Esc: 끝내기</translation>
    </message>
    <message>
        <source>There is no room for more.</source>
        <translation>더 넣을 자리가 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsDelegate</name>
    <message>
        <source>cancelled</source>
        <translation>취소됨</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsList</name>
    <message>
        <source>%1 s</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1분 %2초</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>계산 중</translation>
    </message>
</context>
<context>
    <name>blossom::ui::JobsPanel</name>
    <message>
        <source>Jobs</source>
        <translation>작업</translation>
    </message>
    <message>
        <source>Click: cancel %1</source>
        <translation>클릭: %1 취소</translation>
    </message>
    <message>
        <source>Cross: cancel · Right click: more</source>
        <translation>십자: 취소 · 오른쪽 클릭: 더 보기</translation>
    </message>
    <message>
        <source>Right click: copy the message, forget what has finished</source>
        <translation>오른쪽 클릭: 메시지 복사, 끝난 것 지우기</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Copy the message</source>
        <translation>메시지 복사</translation>
    </message>
    <message>
        <source>Forget what has finished</source>
        <translation>끝난 것 지우기</translation>
    </message>
    <message>
        <source>Nothing is being computed, read or written.</source>
        <translation>계산하거나 읽거나 쓰는 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::KeyMarks</name>
    <message>
        <source>Keys</source>
        <translation>키프레임</translation>
    </message>
    <message>
        <source>Drag a key to another frame; double-click to set one, Delete or a right click to remove one</source>
        <translation>키를 다른 프레임으로 끕니다. 두 번 클릭하면 추가하고, Delete나 오른쪽 클릭으로 지웁니다</translation>
    </message>
</context>
<context>
    <name>blossom::ui::KeyRecorder</name>
    <message>
        <source>Press keys…</source>
        <translation>키를 누르십시오…</translation>
    </message>
    <message>
        <source>No keys: click to set</source>
        <translation>단축키 없음: 클릭하여 지정</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListField</name>
    <message>
        <source>Add an item</source>
        <translation>항목 추가</translation>
    </message>
    <message>
        <source>Add an item to %1</source>
        <translation>%1에 항목 추가</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1개 더</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>모두 제거</translation>
    </message>
    <message>
        <source>Add the missing items</source>
        <translation>빠진 항목 추가</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ListRow</name>
    <message>
        <source>Drag to another place</source>
        <translation>다른 자리로 끌기</translation>
    </message>
    <message>
        <source>Move or copy this item</source>
        <translation>이 항목 이동 또는 복사</translation>
    </message>
    <message>
        <source>Remove this item</source>
        <translation>이 항목 제거</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>아래로</translation>
    </message>
    <message>
        <source>Copy below</source>
        <translation>아래에 복사</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogAndJobs</name>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>&amp;Jobs</source>
        <translation>작업(&amp;J)</translation>
    </message>
    <message>
        <source>Show what is being computed, read and written.</source>
        <translation>계산하고 읽고 쓰는 것을 보입니다.</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Log</source>
        <translation>기록(&amp;L)</translation>
    </message>
    <message>
        <source>Show what has happened so far.</source>
        <translation>지금까지 있었던 일을 보입니다.</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>JOBS</source>
        <translation>작업</translation>
    </message>
    <message>
        <source>LOG</source>
        <translation>기록</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogList</name>
    <message>
        <source>Opened %1.</source>
        <translation>%1을(를) 열었습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>기록</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>모두</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>경고와 오류</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>오류</translation>
    </message>
    <message>
        <source>Which messages</source>
        <translation>어떤 메시지</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>거르기</translation>
    </message>
    <message>
        <source>Copy what is selected, or everything shown</source>
        <translation>고른 것 또는 보이는 것 모두 복사</translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation>기록 지우기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MainWindow</name>
    <message>
        <source>Not every plugin could be loaded.</source>
        <translation>불러오지 못한 플러그인이 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>편집</translation>
    </message>
    <message>
        <source>Find a co&amp;mmand…</source>
        <translation>명령 찾기(&amp;M)…</translation>
    </message>
    <message>
        <source>Find a command, a sample, a feature or a page of the manual by a few letters.</source>
        <translation>몇 글자로 명령, 예제, 피처, 설명서 쪽을 찾습니다.</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>맞추기(&amp;F)</translation>
    </message>
    <message>
        <source>Show everything.</source>
        <translation>모두 보입니다.</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>처음 보기(&amp;H)</translation>
    </message>
    <message>
        <source>Look at everything as when it was opened.</source>
        <translation>열었을 때처럼 전체를 봅니다.</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>확대(&amp;I)</translation>
    </message>
    <message>
        <source>Come nearer.</source>
        <translation>더 가까이 갑니다.</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>축소(&amp;O)</translation>
    </message>
    <message>
        <source>Step back.</source>
        <translation>물러섭니다.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>앞</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>위</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>아래</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>등각</translation>
    </message>
    <message>
        <source>Loo&amp;k from</source>
        <translation>보는 방향(&amp;K)</translation>
    </message>
    <message>
        <source>Look from: %1.</source>
        <translation>보는 방향: %1.</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>평행 투영(&amp;P)</translation>
    </message>
    <message>
        <source>Without perspective: equal lengths look equal.</source>
        <translation>원근 없이 같은 길이가 같게 보입니다.</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>격자(&amp;G)</translation>
    </message>
    <message>
        <source>Show the ground grid.</source>
        <translation>바닥 격자를 보입니다.</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>선택(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>테마(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>도구</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>다른 이름으로 저장…</translation>
    </message>
    <message>
        <source>No safety copy of %1 can be kept: %2</source>
        <translation>%1의 안전 사본을 둘 수 없습니다: %2</translation>
    </message>
    <message>
        <source>%1: find a command · Drop files to open them</source>
        <translation>%1: 명령 찾기 · 파일을 놓으면 열립니다</translation>
    </message>
    <message>
        <source>Theme of the &amp;desktop</source>
        <translation>데스크톱 테마(&amp;D)</translation>
    </message>
    <message>
        <source>The window is dark or light as the desktop is.</source>
        <translation>창이 데스크톱처럼 어둡거나 밝습니다.</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>어두운 테마(&amp;D)</translation>
    </message>
    <message>
        <source>Light letters on dark ground.</source>
        <translation>어두운 바탕에 밝은 글자.</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>밝은 테마(&amp;L)</translation>
    </message>
    <message>
        <source>Dark letters on light ground.</source>
        <translation>밝은 바탕에 어두운 글자.</translation>
    </message>
    <message>
        <source>zoom to fit;zoom all;frame</source>
        <translation>전체 보기;맞춤;확대</translation>
    </message>
    <message>
        <source>orthographic;perspective</source>
        <translation>직교;원근</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualText</name>
    <message>
        <source># No such page

The manual has no page &quot;%1&quot;.</source>
        <translation># 그런 쪽이 없습니다

설명서에 &quot;%1&quot; 쪽이 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ManualWindow</name>
    <message>
        <source>Blossom manual</source>
        <translation>Blossom 설명서</translation>
    </message>
    <message>
        <source>%1 – Blossom manual</source>
        <translation>%1 – Blossom 설명서</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>설명서에서 찾기</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>앞으로</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>첫 쪽</translation>
    </message>
    <message>
        <source>Alt+Home</source>
        <translation>Alt+Home</translation>
    </message>
    <message>
        <source>Nothing in the manual has all of these words.</source>
        <translation>이 낱말이 모두 든 곳이 설명서에 없습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasurePanel</name>
    <message>
        <source>Click a face, an edge or a point.</source>
        <translation>면, 모서리 또는 점을 클릭하십시오.</translation>
    </message>
    <message>
        <source>Copy the figures (Ctrl+C)</source>
        <translation>수치 복사(Ctrl+C)</translation>
    </message>
    <message>
        <source>Delete the measurement (Del)</source>
        <translation>측정 삭제(Del)</translation>
    </message>
    <message>
        <source>Delete all measurements</source>
        <translation>모든 측정 삭제</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>MEASUREMENTS</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>점</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MeasureTool</name>
    <message>
        <source>Click: measure to %1 · Enter: keep as it is</source>
        <translation>클릭: %1까지 측정 · Enter: 그대로 두기</translation>
    </message>
    <message>
        <source>Click a second part · Enter: keep as it is · Del: delete</source>
        <translation>두 번째 부분 클릭 · Enter: 그대로 두기 · Del: 삭제</translation>
    </message>
    <message>
        <source>Click: measure %1</source>
        <translation>클릭: %1 측정</translation>
    </message>
    <message>
        <source>Click a face, an edge or a point to measure it · Esc: finish</source>
        <translation>면, 모서리, 점을 클릭하여 측정 · Esc: 끝내기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Measurements</name>
    <message>
        <source>What was measured is no longer in the document.</source>
        <translation>측정한 것이 이제 문서에 없습니다.</translation>
    </message>
    <message>
        <source>%1 has no shape at present.</source>
        <translation>%1에는 지금 형상이 없습니다.</translation>
    </message>
    <message>
        <source>%1, face %2</source>
        <translation>%1, 면 %2</translation>
    </message>
    <message>
        <source>%1, edge %2</source>
        <translation>%1, 모서리 %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, 점 %2</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>잃음</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>측정 중</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1에서 %2까지</translation>
    </message>
</context>
<context>
    <name>blossom::ui::MouseNavigation</name>
    <message>
        <source>Orbiting</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Panning</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Zooming</source>
        <translation>확대</translation>
    </message>
    <message>
        <source>Selects what the box touches</source>
        <translation>상자에 닿는 것을 선택합니다</translation>
    </message>
    <message>
        <source>Selects what lies wholly in the box</source>
        <translation>상자에 완전히 든 것을 선택합니다</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Navigation</name>
    <message>
        <source>left and middle drag</source>
        <translation>왼쪽·가운데 끌기</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>가운데 끌기</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>오른쪽 끌기</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>끌기</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>확대</translation>
    </message>
    <message>
        <source>select by a box</source>
        <translation>상자로 선택</translation>
    </message>
    <message>
        <source>Click: select</source>
        <translation>클릭: 선택</translation>
    </message>
    <message>
        <source>Wheel: zoom</source>
        <translation>휠: 확대</translation>
    </message>
    <message>
        <source>Double click: fit</source>
        <translation>두 번 클릭: 맞추기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::NumberField</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>must be given</source>
        <translation>꼭 지정해야 함</translation>
    </message>
    <message>
        <source>%1
Drag sideways to change it.</source>
        <translation>%1
옆으로 끌면 바뀝니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::NumbersDialog</name>
    <message>
        <source>Named numbers</source>
        <translation>이름 붙은 수</translation>
    </message>
    <message>
        <source>A name can be used in every field of this document, as in width/2 + 3 mm. A value without a unit is a plain number.</source>
        <translation>이름은 이 문서의 모든 입력란에서 쓸 수 있습니다(예: width/2 + 3 mm). 단위가 없는 값은 단순한 수입니다.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Comes to</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Remove row</source>
        <translation>행 삭제</translation>
    </message>
    <message>
        <source>Change named numbers</source>
        <translation>이름 붙은 수 변경</translation>
    </message>
</context>
<context>
    <name>blossom::ui::OpenDocuments</name>
    <message>
        <source>Not saved yet</source>
        <translation>아직 저장하지 않음</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Painter</name>
    <message>
        <source>The graphics driver offers no OpenGL, which the view needs.</source>
        <translation>그래픽 드라이버가 보기에 필요한 OpenGL을 제공하지 않습니다.</translation>
    </message>
    <message>
        <source>The graphics driver has no OpenGL 3.2, which the view needs.</source>
        <translation>그래픽 드라이버에 보기에 필요한 OpenGL 3.2가 없습니다.</translation>
    </message>
    <message>
        <source>The graphics driver has taken OpenGL away. Save the document, then start Blossom again.</source>
        <translation>그래픽 드라이버가 OpenGL을 해제했습니다. 문서를 저장한 다음 Blossom을 다시 시작하십시오.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ParameterField</name>
    <message>
        <source>%1 of %2</source>
        <translation>%2의 %1</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>기본값으로 되돌리기</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> 이전 값을 유지합니다.</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>값 복사</translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation>값 붙여넣기</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>비우기</translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation>%1(으)로 되돌리기</translation>
    </message>
    <message>
        <source>Each with %1.</source>
        <translation>항목마다 %1.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 또는 %2</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PointTool</name>
    <message>
        <source>Ctrl: no snapping</source>
        <translation>Ctrl: 스냅 없음</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Preferences</name>
    <message>
        <source>Look</source>
        <translation>모양</translation>
    </message>
    <message>
        <source>Colours of the window; system follows the desktop.</source>
        <translation>창의 색입니다. 시스템은 데스크톱 설정을 따릅니다.</translation>
    </message>
    <message>
        <source>Language of the window, from the next start on.</source>
        <translation>창의 언어이며 다음 시작부터 적용됩니다.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>Which mouse buttons turn, shift and zoom the view.</source>
        <translation>보기를 회전, 이동, 확대하는 마우스 단추입니다.</translation>
    </message>
    <message>
        <source>Of a document when it is opened.</source>
        <translation>문서를 열 때의 투영입니다.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>작업</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved changes that is offered after a crash.</source>
        <translation>저장하지 않은 변경의 사본을 두었다가 비정상 종료 후에 제공합니다.</translation>
    </message>
    <message>
        <source>Time between two such copies, in minutes.</source>
        <translation>사본을 만드는 간격(분)입니다.</translation>
    </message>
    <message>
        <source>Processor cores to compute with; 0 takes all of them.</source>
        <translation>계산에 쓸 프로세서 코어 수입니다. 0이면 모두 씁니다.</translation>
    </message>
    <message>
        <source>How far what is drawn may lie from the shape itself; 0: chosen by its size. Results and files do not depend on it.</source>
        <translation>화면에 그린 것이 실제 형상에서 벗어날 수 있는 거리입니다. 0이면 형상의 크기에 맞추어 정합니다. 결과와 파일은 이 값의 영향을 받지 않습니다.</translation>
    </message>
    <message>
        <source>In which lengths are shown, and what a number without a unit means. Files stay in mm.</source>
        <translation>길이를 표시하는 단위이며, 단위 없이 적은 수의 단위이기도 합니다. 파일은 그대로 mm입니다.</translation>
    </message>
    <message>
        <source>How many dark stripes the surroundings have that zebra stripes mirror.</source>
        <translation>얼룩말 줄무늬로 비치는 주변에 있는 어두운 줄의 수입니다.</translation>
    </message>
    <message>
        <source>How far these stripes are turned from level.</source>
        <translation>이 줄무늬를 수평에서 돌린 각도입니다.</translation>
    </message>
    <message>
        <source>How many curves of constant parameter a face shows in each direction.</source>
        <translation>면이 각 방향으로 보이는 등매개변수 곡선의 수입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PreferencesCommands</name>
    <message>
        <source>Edit</source>
        <translation>편집</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>단축키(&amp;K)…</translation>
    </message>
    <message>
        <source>Choose the keys of every command.</source>
        <translation>모든 명령의 단축키를 정합니다.</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>환경 설정(&amp;F)…</translation>
    </message>
    <message>
        <source>Look, units, navigation, autosave and threads.</source>
        <translation>모양, 단위, 탐색, 자동 저장, 스레드입니다.</translation>
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
        <translation>환경 설정</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>&amp;Reset this page</source>
        <translation>이 쪽 초기화(&amp;R)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::PropertyPanel</name>
    <message>
        <source>PROPERTIES</source>
        <translation>속성</translation>
    </message>
    <message>
        <source>There is nothing in this document yet.</source>
        <translation>이 문서에는 아직 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>Select a feature to see what it is made from and what it came to.</source>
        <translation>피처를 고르면 무엇으로 만들어졌고 결과가 무엇인지 보입니다.</translation>
    </message>
    <message>
        <source>The plugin that makes &quot;%1&quot; is not installed.</source>
        <translation>&quot;%1&quot;을(를) 만드는 플러그인이 설치되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>INPUTS</source>
        <translation>입력</translation>
    </message>
    <message>
        <source>RESULT</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%2의 %1 변경</translation>
    </message>
    <message>
        <source>Another file is still being read or written. Wait for it or cancel it.</source>
        <translation>다른 파일을 아직 읽거나 쓰고 있습니다. 기다리거나 취소하십시오.</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>파일 읽는 중</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 이름 바꾸기</translation>
    </message>
    <message>
        <source>%1 more with the results below.</source>
        <translation>아래 결과에 %1개 더 있습니다.</translation>
    </message>
    <message>
        <source>%1 is left out: it does not go with %2 · Undo brings it back</source>
        <translation>%1은(는) %2와(과) 함께 쓸 수 없어 뺐습니다 · 실행 취소하면 돌아옵니다</translation>
    </message>
</context>
<context>
    <name>blossom::ui::RatioSlider</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Recovery</name>
    <message>
        <source>Looking for unsaved documents</source>
        <translation>저장하지 않은 문서 찾는 중</translation>
    </message>
</context>
<context>
    <name>blossom::ui::RecoveryBar</name>
    <message>
        <source>Recover all</source>
        <translation>모두 복구</translation>
    </message>
    <message>
        <source>Not now: they are offered again at the next start</source>
        <translation>나중에: 다음에 시작할 때 다시 물어봅니다</translation>
    </message>
    <message>
        <source>%1, last step: %2</source>
        <translation>%1, 마지막 단계: %2</translation>
    </message>
    <message>
        <source>Was never saved</source>
        <translation>저장한 적 없음</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>A document was not saved when Blossom last ended.</source>
        <translation>Blossom이 마지막으로 끝날 때 저장하지 않은 문서가 하나 있습니다.</translation>
    </message>
    <message>
        <source>%1 documents were not saved when Blossom last ended.</source>
        <translation>Blossom이 마지막으로 끝날 때 저장하지 않은 문서가 %1개 있습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ResultRows</name>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Click to copy</source>
        <translation>클릭하여 복사</translation>
    </message>
    <message>
        <source>Copied %1</source>
        <translation>%1 복사됨</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>복사됨</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>값 복사</translation>
    </message>
    <message>
        <source>Copy name and value</source>
        <translation>이름과 값 복사</translation>
    </message>
    <message>
        <source>Copy all results</source>
        <translation>모든 결과 복사</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ResultTable</name>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>계산 중…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>from the cache</source>
        <translation>캐시에서</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>계산</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>취소되었습니다.</translation>
    </message>
    <message>
        <source>Out of date: computing…</source>
        <translation>오래된 값: 계산 중…</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionPanel</name>
    <message>
        <source>Flip</source>
        <translation>뒤집기</translation>
    </message>
    <message>
        <source>Cut away the other side (F)</source>
        <translation>반대쪽 잘라내기(F)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>끄기</translation>
    </message>
    <message>
        <source>Show everything whole again (Del)</source>
        <translation>다시 전체 보이기(Del)</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>단면</translation>
    </message>
    <message>
        <source>Across the x axis (X)</source>
        <translation>x축에 수직(X)</translation>
    </message>
    <message>
        <source>Across the y axis (Y)</source>
        <translation>y축에 수직(Y)</translation>
    </message>
    <message>
        <source>Across the z axis (Z)</source>
        <translation>z축에 수직(Z)</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>면</translation>
    </message>
    <message>
        <source>Parallel to a face that you pick (P)</source>
        <translation>고른 면에 평행(P)</translation>
    </message>
    <message>
        <source>Offset of the section</source>
        <translation>단면의 위치</translation>
    </message>
    <message>
        <source>Where it cuts, such as 12.5 or 1/2 in</source>
        <translation>자르는 위치. 예: 12.5 또는 1/2 in</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SectionTool</name>
    <message>
        <source>Click a face: the section becomes parallel to it · Esc: keep the direction</source>
        <translation>면 클릭: 단면이 그 면에 평행해짐 · Esc: 방향 유지</translation>
    </message>
    <message>
        <source>Ctrl: in steps of the grid</source>
        <translation>Ctrl: 격자 단위로</translation>
    </message>
    <message>
        <source>Drag: move the section along its direction</source>
        <translation>끌기: 단면을 방향대로 이동</translation>
    </message>
    <message>
        <source>Drag the handle · X, Y, Z: direction · P: of a face · F: flip · Up, Down: a step · Del: off · Esc: finish</source>
        <translation>손잡이 끌기 · X, Y, Z: 방향 · P: 면 기준 · F: 뒤집기 · 위아래: 한 단계 · Del: 끄기 · Esc: 끝내기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Session</name>
    <message>
        <source>Untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>실행 취소: %1</translation>
    </message>
    <message>
        <source>The file is written as soon as all of it is computed.</source>
        <translation>모두 계산되는 대로 파일을 씁니다.</translation>
    </message>
    <message>
        <source>Computing was cancelled; what was ready is shown.</source>
        <translation>계산을 취소했습니다. 끝난 것까지 보입니다.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 여는 중</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 가져오기</translation>
    </message>
    <message>
        <source>Import %1 files</source>
        <translation>파일 %1개 가져오기</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 저장 중</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1(으)로 저장했습니다.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 내보내는 중</translation>
    </message>
    <message>
        <source>%1 in %2 s</source>
        <translation>%1, %2초</translation>
    </message>
    <message>
        <source>Exported %1: %2.</source>
        <translation>%1을(를) 내보냈습니다: %2.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 가져오는 중</translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation>%1 복구 중</translation>
    </message>
    <message>
        <source>%1 is as it was after &quot;%2&quot;.</source>
        <translation>%1은(는) &quot;%2&quot; 다음의 상태입니다.</translation>
    </message>
    <message>
        <source>%1 files, %2</source>
        <translation>파일 %1개, %2</translation>
    </message>
    <message>
        <source>Cancelled: %1.</source>
        <translation>취소함: %1.</translation>
    </message>
    <message>
        <source>%1 was not opened here: this document was edited while it was read.</source>
        <translation>%1을(를) 여기서 열지 않았습니다. 읽는 동안 이 문서가 편집되었습니다.</translation>
    </message>
    <message>
        <source>What was edited is kept. Open it again; it comes in a tab of its own.</source>
        <translation>편집한 내용은 그대로 있습니다. 파일을 다시 열면 새 탭에 열립니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ShortcutEditor</name>
    <message>
        <source>Search commands and keys</source>
        <translation>명령과 단축키 찾기</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>&amp;No keys</source>
        <translation>단축키 없음(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Standard keys</source>
        <translation>기본 단축키(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Take them from there</source>
        <translation>거기서 가져오기(&amp;T)</translation>
    </message>
    <message>
        <source>Click the keys and press others, or press Enter in the list.</source>
        <translation>단축키를 클릭하고 다른 키를 누르거나 목록에서 Enter를 누르십시오.</translation>
    </message>
    <message>
        <source>Select a command to change its keys.</source>
        <translation>단축키를 바꿀 명령을 고르십시오.</translation>
    </message>
    <message>
        <source>%1 already belongs to &quot;%2&quot; in %3.</source>
        <translation>%1은(는) 이미 %3의 &quot;%2&quot;에 쓰입니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SnapPlace</name>
    <message>
        <source>grid</source>
        <translation>격자</translation>
    </message>
    <message>
        <source>on the edge</source>
        <translation>모서리 위</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>중점</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>중심</translation>
    </message>
    <message>
        <source>point</source>
        <translation>점</translation>
    </message>
</context>
<context>
    <name>blossom::ui::StartPage</name>
    <message>
        <source>RECENT</source>
        <translation>최근</translation>
    </message>
    <message>
        <source>SAMPLES</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>Start with a shape</source>
        <translation>형상으로 시작하기</translation>
    </message>
    <message>
        <source>Take a sample, or drop files anywhere on the window.</source>
        <translation>예제를 고르거나 창 아무 데나 파일을 놓으십시오.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>새로 만들기</translation>
    </message>
    <message>
        <source>Start an empty document.</source>
        <translation>빈 문서를 시작합니다.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>가져오기…</translation>
    </message>
    <message>
        <source>Start a document with geometry from files.</source>
        <translation>파일의 형상으로 문서를 시작합니다.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>열기…</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>고정 해제</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>폴더에서 보기</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>목록에서 빼기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Show all jobs</source>
        <translation>모든 작업 보이기</translation>
    </message>
    <message>
        <source> %1 %</source>
        <translation> %1 %</translation>
    </message>
    <message>
        <source>%1 jobs: </source>
        <translation>작업 %1개: </translation>
    </message>
    <message>
        <source>What a click in the view selects</source>
        <translation>보기에서 클릭하면 선택되는 것</translation>
    </message>
    <message>
        <source>Select: %1</source>
        <translation>선택: %1</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SubShapeField</name>
    <message>
        <source>Lost: not found again after an edit. Pick it anew, or remove it.</source>
        <translation>잃음: 편집 후 다시 찾지 못했습니다. 다시 선택하거나 제거하십시오.</translation>
    </message>
    <message>
        <source>Pick in the view: %1</source>
        <translation>보기에서 고르기: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>One must be given; pick another one instead.</source>
        <translation>하나는 지정해야 합니다. 다른 것을 고르십시오.</translation>
    </message>
    <message>
        <source>Click every %1 for %2, again to let go; Esc ends</source>
        <translation>%2(으)로 쓸 %1을(를) 모두 클릭, 다시 클릭하면 해제, Esc: 끝내기</translation>
    </message>
    <message>
        <source>Click the %1 for %2; Esc ends</source>
        <translation>%2(으)로 쓸 %1을(를) 클릭, Esc: 끝내기</translation>
    </message>
    <message>
        <source>That is not a part of an input of this feature.</source>
        <translation>이 피처의 입력에 속한 부분이 아닙니다.</translation>
    </message>
    <message>
        <source>That is no %1 but a %2.</source>
        <translation>%1이(가) 아니라 %2입니다.</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>보기에서 고르기</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>모두 제거</translation>
    </message>
    <message>
        <source>%1; pick in the view</source>
        <translation>%1. 보기에서 고르십시오</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Swatch</name>
    <message>
        <source>Choose another colour</source>
        <translation>다른 색 고르기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::SwitchBox</name>
    <message>
        <source>on</source>
        <translation>켬</translation>
    </message>
    <message>
        <source>off</source>
        <translation>끔</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TextField</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tile</name>
    <message>
        <source>Pinned</source>
        <translation>고정됨</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>이제 없음</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TimelineBar</name>
    <message>
        <source>First frame</source>
        <translation>첫 프레임</translation>
    </message>
    <message>
        <source>Frame before</source>
        <translation>이전 프레임</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>재생</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>다음 프레임</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>마지막 프레임</translation>
    </message>
    <message>
        <source>Begin anew at the end</source>
        <translation>끝나면 처음부터</translation>
    </message>
    <message>
        <source>Onion skin: show the other frames faintly</source>
        <translation>어니언 스킨: 다른 프레임을 흐리게 표시</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 프레임/초</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>How fast it plays</source>
        <translation>재생 속도</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Play: makes a sequence of frames first</source>
        <translation>재생: 먼저 프레임 시퀀스를 만듭니다</translation>
    </message>
    <message>
        <source>Key at this frame</source>
        <translation>이 프레임의 키</translation>
    </message>
</context>
<context>
    <name>blossom::ui::Tour</name>
    <message>
        <source>Begin with a sample</source>
        <translation>예제로 시작하기</translation>
    </message>
    <message>
        <source>The start page opens samples and your last documents with one click. Files can be dropped anywhere on the window.</source>
        <translation>시작 화면에서 예제와 최근 문서를 한 번의 클릭으로 엽니다. 파일은 창 아무 데나 놓을 수 있습니다.</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>문서</translation>
    </message>
    <message>
        <source>Every feature stands here, above what is made from it, with what it came to below its name. A failing feature says why; the rest of the document lives on.</source>
        <translation>모든 피처가 여기에 있으며, 그것으로 만든 것보다 위에 놓이고 이름 아래에 결과가 보입니다. 실패한 피처는 이유를 말하고 문서의 나머지는 그대로 살아 있습니다.</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>속성</translation>
    </message>
    <message>
        <source>What is selected shows its parameters and its result. Values may be expressions with units, such as 3cm + 1/2 in, and every change can be undone.</source>
        <translation>고른 것의 매개변수와 결과가 보입니다. 값은 3cm + 1/2 in처럼 단위가 든 식이어도 되고, 모든 변경은 되돌릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Canvas and palette</source>
        <translation>화면과 팔레트</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do.</source>
        <translation>끌면 돌고, 휠을 돌리면 가까워지고, 클릭하면 선택됩니다. 상태 줄은 마우스가 무엇을 할지 늘 알려 줍니다.</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to come nearer, click to select. The status line always tells what the mouse would do. %1 finds every command by name.</source>
        <translation>끌면 돌고, 휠을 돌리면 가까워지고, 클릭하면 선택됩니다. 상태 줄은 마우스가 무엇을 할지 늘 알려 줍니다. %1을(를) 누르면 모든 명령을 이름으로 찾습니다.</translation>
    </message>
</context>
<context>
    <name>blossom::ui::TourBubble</name>
    <message>
        <source>&amp;Skip</source>
        <translation>건너뛰기(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>뒤로(&amp;B)</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>둘러보기</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>끝(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>다음(&amp;N)</translation>
    </message>
</context>
<context>
    <name>blossom::ui::UnsavedDialog</name>
    <message>
        <source>Save all</source>
        <translation>모두 저장</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>저장하지 않은 변경</translation>
    </message>
    <message>
        <source>%1 documents have changes that are not saved.</source>
        <translation>저장하지 않은 변경이 있는 문서가 %1개입니다.</translation>
    </message>
    <message>
        <source>Those that are ticked are saved; the changes of the others are lost.</source>
        <translation>표시한 것은 저장하고, 나머지의 변경은 사라집니다.</translation>
    </message>
    <message>
        <source>Discard all</source>
        <translation>모두 버리기</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Save %1 of %2</source>
        <translation>%2개 가운데 %1개 저장</translation>
    </message>
</context>
<context>
    <name>blossom::ui::VectorField</name>
    <message>
        <source>Pick a point in the view</source>
        <translation>보기에서 점 고르기</translation>
    </message>
    <message>
        <source>Pick a face in the view; its normal is taken</source>
        <translation>보기에서 면 고르기: 법선을 씁니다</translation>
    </message>
    <message>
        <source> The value before is kept.</source>
        <translation> 이전 값을 유지합니다.</translation>
    </message>
    <message>
        <source>Click where %1 is to be; Esc ends</source>
        <translation>%1을(를) 둘 곳을 클릭하십시오. Esc: 끝내기</translation>
    </message>
    <message>
        <source>Click a face whose normal is to be %1; Esc ends</source>
        <translation>법선을 %1(으)로 쓸 면을 클릭하십시오. Esc: 끝내기</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>보기에서 고르기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCommands</name>
    <message>
        <source>Select</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>F&amp;eatures</source>
        <translation>피처(&amp;E)</translation>
    </message>
    <message>
        <source>A click in the view selects whole features.</source>
        <translation>보기를 클릭하면 피처 전체가 선택됩니다.</translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation>면(&amp;F)</translation>
    </message>
    <message>
        <source>A click in the view selects faces.</source>
        <translation>보기를 클릭하면 면이 선택됩니다.</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>모서리(&amp;D)</translation>
    </message>
    <message>
        <source>A click in the view selects edges.</source>
        <translation>보기를 클릭하면 모서리가 선택됩니다.</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>점(&amp;P)</translation>
    </message>
    <message>
        <source>A click in the view selects points.</source>
        <translation>보기를 클릭하면 점이 선택됩니다.</translation>
    </message>
    <message>
        <source>&amp;Any part</source>
        <translation>모든 부분(&amp;A)</translation>
    </message>
    <message>
        <source>A click in the view selects the nearest face, edge or point.</source>
        <translation>보기를 클릭하면 가장 가까운 면, 모서리, 점이 선택됩니다.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>Shaded with &amp;edges</source>
        <translation>음영과 모서리(&amp;E)</translation>
    </message>
    <message>
        <source>Draw faces and their edges.</source>
        <translation>면과 모서리를 그립니다.</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>음영(&amp;S)</translation>
    </message>
    <message>
        <source>Draw faces alone.</source>
        <translation>면만 그립니다.</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>와이어프레임(&amp;W)</translation>
    </message>
    <message>
        <source>Draw edges alone.</source>
        <translation>모서리만 그립니다.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>측정(&amp;M)</translation>
    </message>
    <message>
        <source>Measure lengths, distances, angles, radii and areas by clicking.</source>
        <translation>클릭하여 길이, 거리, 각도, 반지름, 면적을 잽니다.</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>단면(&amp;S)</translation>
    </message>
    <message>
        <source>Cut the model open with a plane that can be dragged.</source>
        <translation>끌 수 있는 평면으로 모델을 잘라 봅니다.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>재생 또는 일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>Run through the frames of the sequence shown.</source>
        <translation>표시된 시퀀스의 프레임을 재생합니다.</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>다음 프레임(&amp;N)</translation>
    </message>
    <message>
        <source>Show the next frame of the sequence.</source>
        <translation>시퀀스의 다음 프레임을 표시합니다.</translation>
    </message>
    <message>
        <source>Pre&amp;vious frame</source>
        <translation>이전 프레임(&amp;V)</translation>
    </message>
    <message>
        <source>Show the frame before.</source>
        <translation>이전 프레임을 표시합니다.</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>어니언 스킨(&amp;O)</translation>
    </message>
    <message>
        <source>Show the other frames of the sequence faintly.</source>
        <translation>시퀀스의 다른 프레임을 흐리게 표시합니다.</translation>
    </message>
    <message>
        <source>No sequence is shown: a morph with several frames makes one.</source>
        <translation>표시된 시퀀스가 없습니다. 프레임이 여럿인 모프가 시퀀스를 만듭니다.</translation>
    </message>
    <message>
        <source>dimension;distance;ruler;length;angle</source>
        <translation>치수;거리;자;길이;각도</translation>
    </message>
    <message>
        <source>clip;cross section;cutaway</source>
        <translation>자르기;단면;절단</translation>
    </message>
    <message>
        <source>&amp;Zebra stripes</source>
        <translation>얼룩말 줄무늬(&amp;Z)</translation>
    </message>
    <message>
        <source>Faces mirror striped surroundings: stripes bend where surfaces do.</source>
        <translation>면에 줄무늬 주변이 비칩니다. 곡면이 휘는 곳에서 줄무늬도 휩니다.</translation>
    </message>
    <message>
        <source>reflection;continuity;surface quality;highlight lines</source>
        <translation>반사;연속성;곡면 품질;하이라이트 선</translation>
    </message>
    <message>
        <source>&amp;Gaussian curvature</source>
        <translation>가우스 곡률(&amp;G)</translation>
    </message>
    <message>
        <source>Colours of the product of the principal curvatures: domes, saddles, and what can be unrolled.</source>
        <translation>주곡률의 곱을 나타내는 색: 볼록한 곳, 안장, 펼 수 있는 곳.</translation>
    </message>
    <message>
        <source>surface quality;colours;developable</source>
        <translation>곡면 품질;색;가전면</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>평균 곡률(&amp;M)</translation>
    </message>
    <message>
        <source>Colours of the mean of the principal curvatures: bulges, hollows and minimal surfaces.</source>
        <translation>주곡률의 평균을 나타내는 색: 불룩한 곳, 오목한 곳, 극소곡면.</translation>
    </message>
    <message>
        <source>surface quality;colours</source>
        <translation>곡면 품질;색</translation>
    </message>
    <message>
        <source>&amp;Largest curvature</source>
        <translation>최대 곡률(&amp;L)</translation>
    </message>
    <message>
        <source>Colours of the tightest bend at every place: its radius limits tools and offsets.</source>
        <translation>자리마다 가장 급하게 휜 정도를 나타내는 색: 그 반지름이 공구와 오프셋을 제한합니다.</translation>
    </message>
    <message>
        <source>surface quality;colours;radius;principal curvature</source>
        <translation>곡면 품질;색;반지름;주곡률</translation>
    </message>
    <message>
        <source>&amp;Iso-curves</source>
        <translation>아이소커브(&amp;I)</translation>
    </message>
    <message>
        <source>Draw curves of constant parameter on the faces.</source>
        <translation>면 위에 매개변수가 일정한 곡선을 그립니다.</translation>
    </message>
    <message>
        <source>isoparametric;parameter lines;surface quality</source>
        <translation>등매개변수 곡선;매개변수 선;곡면 품질</translation>
    </message>
    <message>
        <source>Surface &amp;quality</source>
        <translation>곡면 품질(&amp;Q)</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewCube</name>
    <message>
        <source>Click: look from %1</source>
        <translation>클릭: %1에서 보기</translation>
    </message>
</context>
<context>
    <name>blossom::ui::ViewWidget</name>
    <message>
        <source>grid %1</source>
        <translation>격자 %1</translation>
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
