#!/usr/bin/env bash
# Morphology of solids: sums, differences, morphs, melting; cancelled and killed
qtest "closed forms of sums" "$build/tests/bin/morphology_sum_test"
at_most "  box + box, error of the volume" "$(figure morphology_sum_test box_box_error)" 1e-9
at_most "  box + prism" "$(figure morphology_sum_test box_prism_error)" 1e-9
at_most "  L + tetrahedron, by hand" "$(figure morphology_sum_test l_tetrahedron_error)" 1e-9
equal "  unit cube + unit cube moved by (5,5,5): volume" "$(figure morphology_sum_test moved_cubes_volume)" 8
qtest "differences, openings, closings" "$build/tests/bin/morphology_difference_test"
at_most "  duality of sum and difference, relative error" "$(figure morphology_difference_test duality_error)" 1e-9
equal "  [-5,5]^3 - [0,1]^3: volume" "$(figure morphology_difference_test difference_volume)" 729
equal "  from" "$(figure morphology_difference_test difference_low)" -5
equal "  to" "$(figure morphology_difference_test difference_high)" 4
qtest "balls, inflating, melting, rounding" "$build/tests/bin/morphology_growth_test"
qtest "morphs" "$build/tests/bin/morphology_morph_test"
at_most "  C(0) and C(1) are the solids, error of the volumes" "$(figure morphology_morph_test morph_ends_error)" 1e-9
qtest "x in A+B exactly when A meets x-B, at random and 1e-6 from the surface" "$build/tests/bin/morphology_membership_test"
at_least "  points" "$(figure morphology_membership_test membership_points)" 4000
equal "  wrong" "$(figure morphology_membership_test membership_wrong)" 0
qtest "volumes against CGAL::minkowski_sum_3" "$build/tests/bin/morphology_cgal_test"
at_most "  largest relative difference" "$(figure morphology_cgal_test cgal_error)" 1e-9
qtest "every feature refuses rubbish, place and remedy named" "$build/tests/bin/morphology_refusal_test"
at_least "  refusals" "$(figure morphology_refusal_test refusals)" 90
qtest "features, structuring elements, formats, command line" "$build/tests/bin/morphology_feature_test"
at_most "  cancelled in the middle of CGAL's work within" "$(figure morphology_feature_test cancel_ms)" 1000 ms
qtest "window: import, add, melt, save; timeline; cancel; helper killed" "$build/tests/bin/morphology_window_test" "BLOSSOM_TEST_PICTURES=$out"
at_most "  cancelled in the window within" "$(figure morphology_window_test window_cancel_ms)" 1000 ms
equal "  its picture (to be looked at): $out/morphology-window.png" "$([ -s "$out/morphology-window.png" ] && echo yes)" yes
