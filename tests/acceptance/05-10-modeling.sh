#!/usr/bin/env bash
# 10: what an outline sweeps never cuts through itself, and nothing counts twice
tool=$(realpath "$bin/blossom")
told() { (cd "$out" && timeout 120 "$tool" "$@" --json 2>/dev/null >answer.json; echo "$?") >"$out/code"; }
refused() { # what place command..
  local what=$1 place=$2; shift 2
  told "$@" -o refused.step
  equal "$what: refused with its place" "$(cat "$out/code") $(grep -oE "near \($place" "$out/answer.json" | head -1)" "1 near ($place"
}
volume() { told "$@" -o made.step; json volume <"$out/answer.json"; }
apart() { awk -v a="${1:-nan}" -v b="$2" 'BEGIN { d = (a - b) / b; printf "%.2g", d < 0 ? -d : d }'; }
drawing() { # name path: millimetres, y downwards
  printf '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><path d="%s"/></svg>' "$2" >"$out/$1.svg"
}
drawing across "M-3 0H5V10H-3Z"
drawing mirrored "M10 0H15V5H10Z M25 0H30V5H25Z"
drawing squares "M-11 -5H-1V5H-11Z M1 -5H11V5H1Z"
drawing wide "M-10 -10H10V10H-10Z"
drawing narrow "M-8 -8H8V8H-8Z"
refused "revolve about (0, 1, 0.001), which the outline crosses" "0, " revolve across.svg --axis 0,1,0.001
at_most "revolve two mirrored rectangles, relative error of the volume" \
  "$(apart "$(volume revolve mirrored.svg --point 20,0,0)" "$(awk 'BEGIN { printf "%.15g", atan2(0, -1) * 375 }')")" 1e-6
# Squares whose sides lean out until they overlap: 2 (10 + 2 s z)^2 - lap^2, the lap 2 s z - 2 wide, with s = 1 over a height of 10
at_most "extrude two squares with a taper of -45 degrees, relative error" \
  "$(apart "$(volume extrude squares.svg --height 10 --taper -45)" \
    "$(awk 'BEGIN { n = 1e6; for (i = 0; i < n; i++) { z = (i + .5) / n * 10; lap = 2 * z - 2; v += (10 + 2 * z) * (2 * (10 + 2 * z) - (lap > 0 ? lap : 0)) * 10 / n } printf "%.15g", v }')")" 1e-6
(cd "$out" && "$tool" text --text lll -o lll.svg >/dev/null 2>&1)
three=$(volume extrude lll.svg --height 2 --taper -40)
equal "extrude text:lll with a taper of -40 degrees: a solid" "$(json closed <"$out/answer.json")" true
refused "loft at heights 0, 20, 10" "" loft wide.svg narrow.svg wide.svg --heights 0,20,10
told box -o b.step
(cd "$out" && "$tool" box -o b.step >/dev/null 2>&1)
told fillet b.step --edges nonsense:edge:3 -o refused.step
equal "fillet --edges nonsense:edge:3" "$(grep -oE 'names no input of Fillet' "$out/answer.json" | head -1)" "names no input of Fillet"
QT_QPA_PLATFORM=offscreen qtest "sound bodies, Pappus and sums by hand" "$build/tests/bin/modeling_sound_test"
