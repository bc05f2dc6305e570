#!/usr/bin/env bash
# Number 1 in the window: swept surfaces are pulled by hand, with the mouse over the real view
qtest "the place under the mouse against a search through dense grids" "$build/tests/bin/sweep_place_test"
qtest "pulls, twists and copies by hand: poles by the paper's formulas, undo bit for bit" "$build/tests/bin/sweep_window_test"
at_most "longest stall while the surface is made ready" "$(figure sweep_window_test pull_hover_stall_ms)" 100 ms
at_least "frames a second during a drag, without a graphics card" "$(figure sweep_window_test pull_frames_per_s)" 20
