#!/usr/bin/env bash
# The live picture of a sweep in the window at 1280x720, without a graphics card
qtest "the shaded surface under the mouse: where it is, how it looks, until it is computed" "$build/tests/bin/sweep_live_window_test"
at_most "  longest stall while a large surface is made ready" "$(figure sweep_live_window_test pull_hover_stall_ms)" 100 ms
at_least "  frames a second while it is dragged" "$(figure sweep_live_window_test pull_frames_per_s)" 20
at_least "  drag frames that follow one another within 33 ms" "$(figure sweep_live_window_test pull_frames_quick_percent)" 95 %
at_most "  95 of 100 drag frames come within" "$(figure sweep_live_window_test pull_frame_95_ms)" 33 ms
at_most "  every pixel drawn after the mouse rests" "$(figure sweep_live_window_test pull_detailed_ms)" 100 ms
at_most "  edges smoothed by eight frames, for the record" "$(figure sweep_live_window_test pull_smooth_ms)" 1000 ms
at_most "  pixels that look otherwise than at rest, handles among them" "$(figure sweep_live_window_test live_pixels_apart)" 0.01
qtest "typed targets and angles, several places, pins, mirrored pulls" "$build/tests/bin/sweep_goal_window_test"
