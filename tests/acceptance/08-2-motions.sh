#!/usr/bin/env bash
# How a motion begins: along a curve, as a plain shape, with more poles
tests=$build/tests/bin
qtest "frames: order, equation, rings, cusps, corners, splines" "$tests/sweep_frames_test"
at_least "  order of convergence on helices and torus knots, at least" "$(figure sweep_frames_test frame_order)" 3.9
at_most "  frames off their differential equation, by integration" "$(figure sweep_frames_test frame_error)" 2e-8 rad
qtest "tubes along random curves; sections of outlines; refusals" "$tests/sweep_along_test"
at_most "  tubes off the true ones, share of the tolerance" "$(figure sweep_along_test tube_share)" 1.1
qtest "plain shapes: closed forms, volumes, nets" "$tests/sweep_primitive_test"
at_most "  points off their closed forms, share of the size" "$(figure sweep_primitive_test primitive_share)" 1e-13
qtest "knots inserted: values, seams, refusals" "$tests/sweep_knots_test"
at_most "  values after insertion, share of the poles" "$(figure sweep_knots_test knots_share)" 1e-13
qtest "sweep-motion, sweep-along and sweep-refine on the command line" "$tests/sweep_begin_test"

# From nothing to a solid, in two commands
"$bin/blossom" sweep-motion --kind torus --radius 30 --profile 10 -o "$out/ring.json" --json >"$out/ring.log" 2>&1
equal "a torus without any file: exit code" "$?" 0
volume=$("$bin/blossom" sweep "$out/ring.json" --solid -o "$out/ring.step" --json 2>>"$out/ring.log" | json volume)
at_most "  volume off 2 pi^2 R r^2" "$(awk -v a="$volume" 'BEGIN { w = 2 * 9.8696044010893586 * 3000; print (a > w ? a - w : w - a) / w }')" 1e-6
"$bin/blossom" stroke --points "0,0,0; 30,10,5; 60,-10,15; 90,0,0" -o "$out/path.step" >"$out/along.log" 2>&1
answer=$("$bin/blossom" sweep-along "$out/path.step" rectangle:8:5 --tolerance 0.01 -o "$out/bar.json" --json 2>>"$out/along.log")
at_most "a bar along a stroke: deviation" "$(json deviation <<<"$answer")" 0.01 mm
"$bin/blossom" sweep "$out/bar.json" --solid -o "$out/bar.step" >>"$out/along.log" 2>&1
equal "  its solid: exit code" "$?" 0
"$bin/blossom" stroke --points "0,0,0; 30,0,0; 30,30,0" --no-smooth -o "$out/corner.step" >>"$out/along.log" 2>&1
answer=$("$bin/blossom" sweep-along "$out/corner.step" -o "$out/corner.json" --json 2>>"$out/along.log")
equal "a path with a corner: exit code, its angle" "$?, $(grep -oE 'corner of 90 degrees' <<<"$answer")" "1, corner of 90 degrees"
