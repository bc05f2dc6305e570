#!/usr/bin/env bash
# Factors: poles and weights of trajectory, orientation and scaling, one by one
tests=$build/tests/bin
qtest "changes of poles by direct formulas, supports, refusals with their place, combs, frames" "$tests/sweep_factors_test"
at_most "  random changes of random motions: poles off the formulas" "$(figure sweep_factors_test factors_pole_difference)" 1e-12
qtest "in the window: poles dragged in space and in the net, turned, typed; knots; undo" "$tests/sweep_factors_window_test"

# On the command line
motions=$root/resources/samples
"$bin/blossom" sweep-factors "$motions/cylinder.json" --scaling '[{"row": 2, "column": 3, "factors": [2, 2, 1]}]' -o "$out/bump.json" >"$out/factors.log" 2>&1
equal "one pole of a cylinder scaled: exit code" "$?" 0
"$bin/blossom" sweep "$out/bump.json" --solid -o "$out/bump.step" >>"$out/factors.log" 2>&1
equal "  its solid: exit code" "$?" 0
answer=$("$bin/blossom" sweep-factors "$motions/cylinder.json" --weights '[{"pole": 1, "weight": 0}]' -o "$out/none.json" --json 2>>"$out/factors.log")
equal "a weight of 0: exit code, place" "$?, $(grep -oE 'weights\[0\], pole 1' <<<"$answer")" "1, weights[0], pole 1"
