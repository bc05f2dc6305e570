#pragma once

namespace blossom::ui {

/// Milliseconds since the system started this process, loading of libraries included; exact to 10 ms.
double msSinceStart();

/// With --print-timings: what has been reached, and when, on standard error. A name is printed once.
void printTimings(bool wanted);
void reached(const char* what);

}  // namespace blossom::ui
