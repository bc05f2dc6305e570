#!/usr/bin/env bash
# Control shapes of samples dragged in the window; morphs beyond their ends; input that cannot be morphed
tests=$build/tests/bin
qtest "control shapes of samples dragged at 1280x720" "$tests/minkowski_frames_window_test"
for sample in triangle_to_star phi_to_flower figure_4_triangle_to_square figure_5_five_pairs figure_6_rounded_by_a_circle; do
  at_least "  ${sample//_/ }: frames that follow one another within 33 ms" "$(figure minkowski_frames_window_test "morph_frames_${sample}_percent")" 95 %
done
qtest "morphs beyond their first and last shape" "$tests/minkowski_beyond_test"

qtest "every feature ends soon after it is cancelled" "$tests/minkowski_cancel_test"
at_most "  at the worst of many places" "$(figure minkowski_cancel_test cancel_everywhere_s)" 0.2 s

# What cannot be morphed is named, with a place and a remedy.
cd "$out"
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><path d="%s"/></svg>' "$1"; }
svg "M0 0 L40 40 L40 0 L0 40 Z" >crossing.svg
svg "M0 0 L40 0 L20 0 Z" >flat.svg
svg "M0 0 L1e13 0 L1e13 1e13 Z" >far.svg
svg "M0 0 $(awk 'BEGIN { for (k = 0; k < 1000000; ++k) { a = 6.283185307179586 * k / 1e6; printf "L%.9g %.9g ", 50 + 40 * cos(a), 50 + 40 * sin(a) } }') Z" >million.svg
for name in crossing flat far million; do
  started=$(date +%s%N)
  "$bin/blossom" morph "$name.svg" circle:5 --t 0.5 --json >"$name.json" 2>/dev/null
  equal "$name: exit code" "$?" 1
  for part in message hint; do at_least "  its $part, letters" "$(json "$part" <"$name.json" | wc -c)" 20; done
  at_most "  told after" "$(( ($(date +%s%N) - started) / 1000000 ))" 5000 ms
done
