#!/usr/bin/env bash
# Coarse and fine: truncated hierarchical B-splines, levels of pulls, conversion to the tensor product
tests=$build/tests/bin
qtest "the hierarchy: truncation, partition of unity, refinement" "$tests/hierarchical_surface_test"
at_most "  hierarchy off its tensor product / size of the poles" "$(figure hierarchical_surface_test hierarchy_share)" 1e-12
at_most "  truncated functions off their definition" "$(figure hierarchical_surface_test truncation_apart)" 1e-12
at_least "  of them truncated" "$(figure hierarchical_surface_test truncated_functions)" 50
at_most "  knot insertion off the relation found from values" "$(figure hierarchical_surface_test two_scale_apart)" 1e-13
qtest "pulls and twists of levels -4 to 5" "$tests/sweep_levels_test"
at_least "  pulls, motions of few rows among them" "$(figure sweep_levels_test level_pulls)" 700
at_most "  farthest miss / size of the poles" "$(figure sweep_levels_test level_miss_share)" 1e-12
at_most "  a pull off the same one in the hierarchy / size of the poles" "$(figure sweep_levels_test hierarchy_pull_apart)" 1e-12
at_most "  change off the shortest one of its level / size of the poles" "$(figure sweep_levels_test level_change_apart)" 1e-12
at_most "  outside its reach: change / size" "$(figure sweep_levels_test outside_reach_share)" 4e-15
at_most "  there and back: values off the start / size of the poles" "$(figure sweep_levels_test level_there_and_back)" 1e-12
at_most "  n-fold: distance of a copy / size of the poles" "$(figure sweep_levels_test level_fold_asymmetry)" 1e-12

# On the command line: a nose on a cylinder, and a belly under it; only the knots that are needed
motions=$root/resources/samples
: >"$out/levels.log"
pulled() { # level, target, output, input
  "$bin/blossom" sweep-pull "$4" --pulls "[{\"u\": 0.2, \"v\": 0.4, \"to\": $2}]" --level "$1" -o "$3" --json 2>>"$out/levels.log"
}
answer=$(pulled 2 "[4, 12, 16]" "$out/nose.json" "$motions/cylinder.json")
at_most "a pull of level 2: what is left" "$(json remainder <<<"$answer")" 1e-12 mm
nose=$("$bin/blossom" sweep "$out/nose.json" --solid -o "$out/nose.step" --json 2>>"$out/levels.log")
volume=$(json volume <<<"$nose")
plain=$("$bin/blossom" sweep "$motions/cylinder.json" --solid -o "$out/plain.step" --json 2>>"$out/levels.log" | json volume)
wide=$(pulled 0 "[4, 12, 16]" "$out/wide.json" "$motions/cylinder.json" >/dev/null; "$bin/blossom" sweep "$out/wide.json" --solid -o "$out/wide.step" --json 2>>"$out/levels.log" | json volume)
at_least "  the solid grows by" "$(awk -v a="$volume" -v b="$plain" 'BEGIN { print a - b }')" 1 mm3
at_least "  that of level 0 by as many times as much" "$(awk -v a="$volume" -v b="$plain" -v c="$wide" 'BEGIN { print (c - b) / (a - b) }')" 4
sed -E '1s/\{/{"edits": [{"at": [0.2, 0.4], "to": [4, 12, 16], "level": 2}],/' "$motions/cylinder.json" >"$out/edits.json"
equal "  the same by the edits of a file: volume" "$("$bin/blossom" sweep "$out/edits.json" --solid -o "$out/edits.step" --json 2>>"$out/levels.log" | json volume)" "$volume"
poles=$("$bin/blossom" sweep-refine "$out/nose.json" -o "$out/same.json" --json 2>>"$out/levels.log" | json poles_u)
answer=$(pulled -1 "[5, 15, 16]" "$out/belly.json" "$out/nose.json")
at_most "a coarser pull over it: what is left" "$(json remainder <<<"$answer")" 1e-12 mm
equal "  it adds no rows" "$("$bin/blossom" sweep-refine "$out/belly.json" -o "$out/same.json" --json 2>>"$out/levels.log" | json poles_u)" "$poles"
sed -E 's/"level": 2/"level": 12/' "$out/edits.json" >"$out/wrong.json"
answer=$("$bin/blossom" sweep "$out/wrong.json" -o "$out/wrong.step" --json 2>>"$out/levels.log")
equal "a level that is none: exit code, place" "$?, $(grep -oE 'edits\[0\]\.level must lie between -8 and 8' <<<"$answer")" "1, edits[0].level must lie between -8 and 8"
qtest "the region shown under the mouse is what changes" "$tests/sweep_region_test"
