#!/usr/bin/env bash
# Number 6: drawing
qtest "the view turns to the plane; keys, mouse and snaps while drawing" "$build/tests/bin/drawing_view_test"
qtest "drawing tools: snapping and typed lengths" "$build/tests/bin/outline_tool_test"
qtest "drawing tools: points and handles are dragged" "$build/tests/bin/outline_handles_test"
