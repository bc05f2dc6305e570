// Carries the precompiled headers of all rooms and plugins.
