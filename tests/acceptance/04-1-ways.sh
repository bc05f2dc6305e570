#!/usr/bin/env bash
# The four ways through the window, from import to saved file
qtest "morph two imported outlines, play the sequence, save it" "$build/tests/bin/minkowski_window_test"
qtest "  the timeline: play, scrub, onion skin" "$build/tests/bin/timeline_window_test"
qtest "add two solids, melt one, save it; the helper process ended by hand" "$build/tests/bin/morphology_window_test"
qtest "medial axis and offset loops of a spline outline with an island" "$build/tests/bin/offset_window_test"
qtest "a pocket program saved" "$build/tests/bin/pocket_window_test"
qtest "part of a subdivision surface pulled to a drawn target" "$build/tests/bin/subdivision_window_test"
for sample in "$root"/resources/samples/*.blossom; do
  name=$(basename "$sample" .blossom)
  for theme in dark light; do
    with_display timeout 300 "$bin/blossom-workbench" "$sample" --theme $theme --size 1280x800 --screenshot "$out/$name-$theme.png" --exit >"$out/window.log" 2>&1
    equal "screenshot of the sample $name, $theme theme, exit code" "$?" 0
  done
done
echo "      look at them in ${out#"$root"/}"
