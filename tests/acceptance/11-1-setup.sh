#!/usr/bin/env bash
# A program in its setup: the whole tool against solid, stock, clamps and travel
qtest "contacts of a tool with triangles, against closed forms and an independent search" "$build/tests/bin/pocket_collision_test"
qtest "carved stock, against closed forms and samples" "$build/tests/bin/pocket_stock_field_test"
qtest "setups as features" "$build/tests/bin/pocket_setup_test"
qtest "good and faulty programs in random setups" "$build/tests/bin/pocket_setup_faults_test"
at_most "good programs that are flagged" "$(figure pocket_setup_faults_test setup_good_flagged)" 0
at_most "faulty programs that are missed" "$(figure pocket_setup_faults_test setup_faulty_missed)" 0
