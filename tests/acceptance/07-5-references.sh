#!/usr/bin/env bash
# Number 5: faces and edges are found again after edits upstream, or lost; never others
for seed in 1 2 3; do
  qtest "102 random edits of six models, seed $seed" "$build/tests/bin/part_reference_test" BLOSSOM_TEST_SEED=$seed
  grep -oE 'all: .*' "$out/part_reference_test.log" | sed 's/^/      /'
done
qtest "edits that give another part its number, neighbours or place" "$build/tests/bin/part_confusion_test"
