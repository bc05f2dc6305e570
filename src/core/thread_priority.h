#pragma once

namespace blossom {

/// The calling thread, and every thread and process it starts from now on, gets the processor after those that somebody
/// looks at. It makes nothing slower while a core is free.
void lowerThreadPriority();

}  // namespace blossom
