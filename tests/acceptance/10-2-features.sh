#!/usr/bin/env bash
# Growing, melting and morphing solids; work that is cancelled; rubbish
tests=$build/tests/bin
qtest "grown and melted by any shape, until nothing is left, rounded" "$tests/morphology_growth_test"
qtest "morphs of two and more solids" "$tests/morphology_morph_test"
qtest "previews on a grid" "$tests/morphology_preview_test"
qtest "closed meshes where solids are taken" "$tests/modeling_mesh_test"
qtest "in the window: facets, previews, radius, timeline, cancelling" "$tests/morphology_window_test"
qtest "features, blossoms, command line" "$tests/morphology_feature_test"
at_most "  cancelled within" "$(figure morphology_feature_test cancel_ms)" 200 ms
qtest "rubbish is refused or repaired, with its place" "$tests/morphology_refusal_test"
if [ -f "$data/solids/gear8.off" ]; then
  (cd "$out" && "$bin/blossom" solid-morph "$data/solids/torus256.off" "$data/solids/gear8.off" --frames 7 -o frame.off --json >morph.json 2>&1)
  equal "seven frames of torus256 to gear8: searches for pairs" "$(json pairings <"$out/morph.json")" 1
  equal "  made by" "$(json way <"$out/morph.json")" arranged
else
  report SKIP "pairs of a morph" "no ../shared/data" ""
fi
