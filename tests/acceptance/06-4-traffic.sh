#!/usr/bin/env bash
# Traffic while dragging: refreshes against event turns and pictures
qtest "a control shape is dragged, and one of 200 features is edited" "$build/tests/bin/refresh_test"
echo "      $(figure refresh_test drag_moves) moves, $(figure refresh_test drag_turns) event turns, $(figure refresh_test drag_pictures) pictures"
for part in view handles tree panel; do
  at_most "refreshes of the $part in one event turn of the drag" "$(figure refresh_test drag_${part}_most_in_a_turn)" 1
done
for part in tabs actions start_page; do
  at_most "refreshes of the ${part/_/ } during the drag, which changes nothing of them" "$(figure refresh_test drag_$part)" 0
done
at_least "200 features after one edit: pictures" "$(figure refresh_test crowd_pictures)" 1
at_most "  refreshes of the view" "$(figure refresh_test crowd_view)" "$(figure refresh_test crowd_pictures)"
at_most "  shapes sent to the graphics card anew; ten have changed" "$(figure refresh_test crowd_actors)" 10
for part in view handles tree panel; do
  at_most "  refreshes of the $part in one event turn" "$(figure refresh_test crowd_${part}_most_in_a_turn)" 1
done
