#!/usr/bin/env bash
# A part and a morph from an empty window; the mouse sends X events, which are counted
qtest "a part from an empty window, volumes after each step, STEP; a morph that plays" "$build/tests/bin/first_part_test"
at_most "clicks for the part" "$(figure first_part_test part_clicks)" 16
at_most "typed values for the part" "$(figure first_part_test part_values)" 6
at_most "clicks for the playing morph" "$(figure first_part_test morph_clicks)" 5
