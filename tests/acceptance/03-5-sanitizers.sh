#!/usr/bin/env bash
# The whole suite under the sanitizers
for preset in asan tsan; do
  if BLOSSOM_PRESET=$preset "$root/dev" build >"$out/$preset-build.log" 2>&1; then
    BLOSSOM_PRESET=$preset "$root/dev" test >"$out/$preset-test.log" 2>&1
    equal "whole test suite under $preset, exit code" "$?" 0
    echo "      $(grep -oE '[0-9]+% tests passed.*' "$out/$preset-test.log" | tail -1)"
  else
    report FAIL "$preset build" "see $preset-build.log" "builds"
  fi
done
