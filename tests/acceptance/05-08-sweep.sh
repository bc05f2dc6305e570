#!/usr/bin/env bash
# Sweep: what a motion says is what is swept
tests=$build/tests/bin
qtest "motions: signs, crossings, few rows, degrees, near misses, rings" "$tests/sweep_sound_test"
equal "  half-angles 0, 100, 200, 300: degrees turned, counted on the motion" "$(figure sweep_sound_test kept_turn_degrees)" 600
at_least "  scaling x 6: the place of the crossing joins parts of v at least apart" "$(figure sweep_sound_test crossing_spans_v)" 0.05
at_most "  drags of closed motions with 1 to 4 rows miss by at most" "$(figure sweep_sound_test few_rows_miss_mm)" 1e-10 mm
at_most "  rings with quaternions of other lengths: volume off the integral" "$(awk -v a="$(figure sweep_sound_test ring_volume_share)" 'BEGIN { print (a > 1 ? a - 1 : 1 - a) }')" 1e-6

# On the command line, where the solid is made by the worker
motions=$root/resources/samples
"$bin/blossom" sweep "$motions/twisted-tube.json" --solid -o "$out/tube.step" --json >"$out/sweep.log" 2>&1
equal "twisted tube: exit code" "$?" 0
# Six times the point is six times the scaling.
sed -E 's/("point": *\[) *1(\.0)? *,/\16.0,/' "$motions/twisted-tube.json" >"$out/tube6.json"
# The point has no y: scaling alone does not reach the target.
sed -E '1s/\{/{"edits": [{"at": [0.5, 0.5], "to": [1, 2, 3], "weights": {"scale": 1}}],/' "$motions/cylinder.json" >"$out/edited.json"
answer=$("$bin/blossom" sweep "$out/tube6.json" --solid -o "$out/tube6.step" --json 2>>"$out/sweep.log")
equal "  scaling x 6: exit code, file written" "$?, $([ -e "$out/tube6.step" ] && echo yes || echo no)" "1, no"
equal "  its message names the place" "$(grep -oE 'crosses itself near \(' <<<"$answer")" "crosses itself near ("
answer=$("$bin/blossom" sweep "$out/edited.json" -o "$out/edited.step" --json 2>>"$out/sweep.log")
equal "a motion with an edit out of reach: exit code, place" "$?, $(grep -oE 'edits\[0\]' <<<"$answer")" "1, edits[0]"
