#!/usr/bin/env bash
# 15: offsets at the edge of what is possible
qtest "15 flat clearances, gaps, jogs, far places, tolerances, joints, discs" "$build/tests/bin/pocket_offset_edges_test"
edges() { figure pocket_offset_edges_test "$1"; }
drawn() { # file path-data
  echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='100mm' height='100mm'><path d='$2'/></svg>" >"$out/$1.svg"
}
drawn neck "M0 0H10V4H20V0H30V10H20V6H10V10H0Z"
equal "  loops at a distance equal to a flat clearance" "$("$bin/blossom" offset "$out/neck.svg" --distance 1 -o "$out/neck.dxf" --json | json loops)" 2
at_most "  their extrusion, error of its volume" "$("$bin/blossom" extrude "$out/neck.dxf" --height 2 -o "$out/neck.step" --json | json volume | awk '{ d = $1 - 4 * (64 + 2 - 3.14159265358979324 / 2); print d < 0 ? -d : d }')" 1e-5 mm3
equal "  \"the distance must be below\" the same distance" "$("$bin/blossom" offset rectangle:40:20 --distance 10 --json 2>/dev/null | json message | grep -c 'must be below')" 0
at_most "  farthest that an offset says it is off, tolerance 0.001 mm" "$(edges offset_farthest_off_mm)" 1e-3 mm
at_least "  discs proved on the curves as drawn" "$(edges discs_proved)" 1
