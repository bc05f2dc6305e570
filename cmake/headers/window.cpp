// Carries the precompiled headers of the window and of what plugins add to it.
