#!/usr/bin/env bash
# Pulling the surface: places arrive, and nothing else moves
tests=$build/tests/bin
qtest "drags of random motions: arrival, shares, support, there and back" "$tests/sweep_pull_test"
at_least "  drags, open, periodic and anti-periodic" "$(figure sweep_pull_test drags)" 20000
at_least "  of them with 1 to 3 rows around" "$(figure sweep_pull_test drags_of_few_rows)" 2000
at_most "  farthest miss / size of the poles" "$(figure sweep_pull_test drag_miss_share)" 1e-12
at_most "  there and back: poles off the start / their size" "$(figure sweep_pull_test there_and_back_share)" 1e-12
qtest "what cannot be reached is named" "$tests/sweep_unreached_test"
qtest "several places with pins" "$tests/sweep_together_test"
at_most "  poles off the shortest change by singular values / its size" "$(figure sweep_together_test shortest_change_apart)" 1e-10
at_most "  contradicting places: poles off the least squares / their size" "$(figure sweep_together_test least_squares_apart)" 1e-12
at_most "  farthest miss / size of the poles" "$(figure sweep_together_test together_miss_share)" 1e-12
qtest "n-fold edits" "$tests/sweep_symmetry_test"
at_most "  2- to 7-fold: distance of a copy / size of the poles" "$(figure sweep_symmetry_test fold_asymmetry)" 1e-12
qtest "mirrored edits, and symmetry that rows do not allow" "$tests/sweep_mirror_test"
at_most "  mirrored, and mirrored fourfold: the same" "$(figure sweep_mirror_test mirror_asymmetry)" 1e-12
qtest "edits of files and features" "$tests/sweep_edits_test"

# On the command line: one pull and one twist make four blades, by commands and by the edits of a file
motions=$root/resources/samples
pull='[{"u": 0.125, "v": 0.5, "to": [30, 30, 20]}]'
answer=$("$bin/blossom" sweep-pull "$motions/cylinder.json" --pulls "$pull" --fold 4 -o "$out/blades.json" --json 2>"$out/pulls.log")
at_most "four blades by one pull: what is left" "$(json remainder <<<"$answer")" 1e-12 mm
"$bin/blossom" sweep-twist "$out/blades.json" --places '[{"u": 0.125, "v": 0.5}]' --axis 1,1,0 --angle 40 --fold 4 -o "$out/twisted.json" --json >>"$out/pulls.log" 2>&1
by_commands=$("$bin/blossom" sweep "$out/twisted.json" --solid -o "$out/twisted.step" --json 2>>"$out/pulls.log")
edits='[{"at": [0.125, 0.5], "to": [30, 30, 20], "symmetry": {"fold": 4}}, {"at": [0.125, 0.5], "twist": {"axis": [1, 1, 0], "angle": 40}, "symmetry": {"fold": 4}}]'
sed -E "1s/\{/{\"edits\": $edits,/" "$motions/cylinder.json" >"$out/edits.json"
by_edits=$("$bin/blossom" sweep "$out/edits.json" --solid -o "$out/edits.step" --json 2>>"$out/pulls.log")
at_least "  the solid: volume" "$(json volume <<<"$by_commands")" 12566.3 mm3
equal "  the same by the edits of a file: volume" "$(json volume <<<"$by_edits")" "$(json volume <<<"$by_commands")"
"$bin/blossom" convert "$out/edits.json" -o "$out/kept.json" --json >>"$out/pulls.log" 2>&1
equal "  edits kept by reading and writing" "$("$bin/blossom" info "$out/kept.json" --json | json edits)" 2
sed -E 's/("fold": 4)\}\}, /\1}}, {"at": [0, 0.5], "to": [15, 3, 20], "weights": {"scale": 1}}, /' "$out/edits.json" >"$out/wrong.json"
answer=$("$bin/blossom" sweep "$out/wrong.json" -o "$out/wrong.step" --json 2>>"$out/pulls.log")
equal "  out of reach: exit code, place" "$?, $(grep -oE 'edits\[1\] cannot be reached: 3 mm' <<<"$answer")" "1, edits[1] cannot be reached: 3 mm"
equal "  the remedy" "$(grep -oE 'Give rotate the share 1' <<<"$answer")" "Give rotate the share 1"
