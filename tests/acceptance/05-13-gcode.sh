#!/usr/bin/env bash
# programs for machines: simulations that see what ruins work (13), programs measured as they are written (14), O-words (23)
qtest "13 simulation: rapids, ridges, blending, closed forms" "$build/tests/bin/pocket_simulate_test"
qtest "13 what a careful reader doubts: H, units, M5, G64, arcs" "$build/tests/bin/gcode_safety_test"
qtest "14 posts: begin, end, dwell, Fanuc's places, read back" "$build/tests/bin/gcode_program_test"
qtest "13, 14 through the command line" "$build/tests/bin/pocket_cli_test"
qtest "13 programs with one fault each, and good ones" "$build/tests/bin/pocket_faults_test" BLOSSOM_FAULTY_PROGRAMS=200
faults() { figure pocket_faults_test "$1"; }
at_least "  of 200 with one fault, told with the line" "$(faults faults_told)" 200
at_most "  of 200 good ones, flagged" "$(faults good_flagged)" 2
grep -E "^figure told_|random seed" "$out/pocket_faults_test.log" | sed 's/^/        /'

blossom=$bin/blossom
(cd "$out" && "$blossom" rectangle --width 60.13 --height 40.27 -o plate.dxf >/dev/null)
simulated() { (cd "$out" && "$blossom" simulate "$1" --part plate.dxf "${@:2}" --json); }
made() { (cd "$out" && "$blossom" pocket plate.dxf "$@" --json); }
made --depth 5 -o good.ngc >/dev/null
sed 's/Z-5\b/Z-5.1/' "$out/good.ngc" >"$out/deep.ngc"
at_least "13 0.1 mm too deep, no depth given: gouge" "$(simulated deep.ngc | json gouge_mm)" 0.0999 mm
sed 's/^(stock X .*/(stock X -5 85.13 Y -5 45.27 Z -7 0)/' "$out/good.ngc" >"$out/stock.ngc"
at_most "13 stock not even around the part: spurious gouge" "$(simulated stock.ngc | json gouge_mm)" 0.005 mm
made --depth 4 --tool-corner 3 --stepover 45% -o ball.ngc >/dev/null
ball=$(simulated ball.ngc)
at_least "13 a ball's ridges" "$(json ridge_mm <<<"$ball")" 0.31 mm
at_least "  and what they leave" "$(json residue_mm2 <<<"$ball")" 1 mm2
coarse=$(made --depth 5 --gcode.unit inch --gcode.decimals 2 -o coarse.ngc)
told=$(json gouge_mm <<<"$coarse")
measured=$(simulated coarse.ngc | json gouge_mm)
at_least "14 inches with 2 decimals: gouge of the file as told" "$told" 0.002 mm
at_most "  off from what its simulation finds" "$(awk -v a="$told" -v b="$measured" 'BEGIN { d = a - b; print d < 0 ? -d : d }')" 1e-9 mm
made --depth 5 --post fanuc -o fanuc.nc >/dev/null
equal "14 Fanuc: most places after the point in mm" "$(grep -v '^(' "$out/fanuc.nc" | grep -oE '[XYZIJ]-?[0-9]*\.[0-9]+' | sed 's/.*\.//' | awk '{ if (length > m) m = length } END { print m }')" 3
equal "14 at the machine's top at begin and end" "$(grep -c '^G53 G0 Z0$' "$out/good.ngc")" 2
equal "14 waits for the spindle" "$(grep -A1 'M3$' "$out/good.ngc" | tail -1)" "G4 P2"
warned() { made "$@" -o hardly.ngc | grep -c "$told_of"; }
equal "14 depth 80 with a tool of 3 mm is told" "$(told_of="26.7 times" warned --depth 80 --tool-diameter 3)" 1
equal "14 a safe height of 0.001 mm is told" "$(told_of="only 0.001 mm above the stock" warned --safe-height 0.001)" 1
printf 'G21 G90\n#1=0\no101 while [#1 lt 4]\nG0 X0 Y0\nG1 X5 F100\n#1=[#1+1]\no101 endwhile\nM2\n' >"$out/loop.ngc"
equal "23 a loop that is not run is told with its line" "$("$blossom" info "$out/loop.ngc" --json | grep -cE 'Line 3: O101.*not run')" 1
