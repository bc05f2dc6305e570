#!/usr/bin/env bash
# Offset and medial axis: real drawings against an independent search, closed forms, peers, rubbish, the window
tests=$build/tests/bin
qtest "every file of svg and dxf: offset at six distances on both sides, or a sentence that says why not" "$tests/pocket_offset_files_test" BLOSSOM_SHARED_DATA="$data"
files() { figure pocket_offset_files_test "$1"; }
at_least "  files" "$(files files)" 71
at_least "  of them with closed outlines that do not cross, offset" "$(files files_offset)" 64
report PASS "  without such outlines, each refused with place and remedy" "$(files files_refused) files" "told apart"
at_least "  offsets" "$(files offsets)" 700
at_least "  their sampled points" "$(files points)" 100000
at_most "  farthest of them from its distance, tolerance 0.001 mm" "$(files worst_offset_mm)" 1e-3 mm
at_least "  random points in or out of the offsets as they should be" "$(files members)" 40000
at_least "  sampled points of the medial axes" "$(files axis_points)" 100000
at_most "  clearance told against the distance found" "$(files worst_axis_mm)" 1e-3 mm
at_most "  the disc's second foot is as near as the first, within" "$(files worst_second_foot_mm)" 1e-3 mm
report PASS "  straight pieces of the largest outline" "$(files most_sites)" "told"
report PASS "  slowest Voronoi diagram of a file" "$(files slowest_diagram_ms) ms" "told"
report PASS "  slowest offset read off it" "$(files slowest_offset_ms) ms" "told"

qtest "closed forms: rectangle, L, annulus, stadium, ellipse; dA/dd = -L; turned, reversed, knots inserted" "$tests/pocket_offset_test"
qtest "medial axes: rectangle, triangle, annulus, stadium, leaves of an ellipse at b^2/a" "$tests/pocket_medial_test"
qtest "sweep line against CGAL's Delaunay graph; clearances; rubbish" "$tests/pocket_diagram_test"
qtest "faces of solids, layers, bands, open lines; refusals with place and remedy" "$tests/pocket_offset_feature_test"

# The file that the command line writes, read back: a rectangle of 60 x 40 with an island of radius 8.
"$bin/blossom" boolean rectangle:60:40 circle:8 --operation difference -o "$out/plate.dxf" --json >/dev/null
inset=$("$bin/blossom" offset "$out/plate.dxf" --distance 3 -o "$out/inset.svg" --json)
at_most "an inset of 3 mm, error of its area" "$(awk -v a="$(json area <<<"$inset")" 'BEGIN { d = a - (54 * 34 - 3.14159265358979324 * 121); print d < 0 ? -d : d }')" 1e-6 mm2
equal "  loops" "$(json loops <<<"$inset")" 2
"$bin/blossom" offset "$out/plate.dxf" --distance 12.5 --json >"$out/too-large.json" 2>/dev/null
equal "a distance that leaves nothing: error" "$(json code <"$out/too-large.json")" InvalidParameter
equal "uncertified vertices of the letters' medial axis" "$("$bin/blossom" medial-axis text:Blossom --json | json uncertified)" 0

qtest "window: outline and island in, axis and rings out as DXF; a face picked; too large a distance" "$tests/offset_window_test" BLOSSOM_PICTURES="$out"
equal "  its pictures (to be looked at): $out/offset-window-*.png" "$([ -s "$out/offset-window-dark.png" ] && [ -s "$out/offset-window-light.png" ] && echo yes)" yes
