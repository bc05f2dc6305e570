#!/usr/bin/env bash
# Number 1 in the window: swept surfaces are pulled by hand, with the mouse over the real view
qtest "the place under the mouse against a search through dense grids" "$build/tests/bin/sweep_place_test"
qtest "pulls, twists and copies by hand: poles by the paper's formulas, undo bit for bit" "$build/tests/bin/sweep_window_test"
qtest "twists by hand, and their axis" "$build/tests/bin/sweep_axis_window_test"
