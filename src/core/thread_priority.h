#pragma once

namespace blossom {

/// Lowers the priority of the calling thread, and of every thread and process it starts from now on, below that of
/// interactive work. Costs no time while a core is free.
void lowerThreadPriority();

}  // namespace blossom
