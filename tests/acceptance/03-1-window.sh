#!/usr/bin/env bash
# The real window under Xvfb, from the first file to the last kill
scenario() { qtest "$1" "$build/tests/bin/$2"; }
scenario "open by drop, palette, edit, reorder, undo, redo, save; pick a face; live preview" workbench_test
scenario "draw an outline with snapping and typed lengths, extrude and fillet it" modeling_window_test
scenario "measure and section" measure_window_test
scenario "the view: picking of features, faces, edges and points, tools, navigation" view_test
scenario "the panel: a field for every kind of parameter, the name, errors, results" panel_form_test
scenario "the panel: typed values" panel_typing_test
scenario "the panel: keys, wheel and dragging" panel_dragging_test
scenario "the panel: lists and records" panel_lists_test
scenario "the panel: picking, inputs" panel_picking_test
scenario "the panel: lengths in the unit preferred" panel_units_test
scenario "preferences change what is shown, not the document" preferences_window_test
scenario "the tree: rename, isolate, delete, reorder, suppress, search" document_tree_test
scenario "the tree: copies within a document and into others" document_clipboard_test
scenario "the tree: failures, what is out of date" shown_failures_test
scenario "the palette" palette_test
scenario "menus and tool bars at any width" menus_and_bars_test
scenario "a job is cancelled; the log" jobs_and_log_test
scenario "files: open, save, guard, damaged documents" window_files_test
scenario "tabs, write-protected and changed files" documents_test
scenario "recent documents, the start page" start_page_test
scenario "several files at once, dropped files, files that cannot be read" opening_files_test
scenario "what a crash left is offered" recovery_bar_test
scenario "edits during opening, importing and saving; typing; closing; values that do not fit; mistakes" unsaved_work_test
scenario "50 times kill -9 in the middle of a save and of an edit, recovered" recovery_test
at_least "  kills" "$(figure recovery_test kills)" 50
at_least "  of them in the middle of a save" "$(figure recovery_test kills_while_saving)" 1
at_most "  most that was lost" "$(figure recovery_test most_lost_ms)" 1000 ms
