#pragma once

namespace blossom {

/// Freed memory stays with this process for what it computes next, up to some hundred megabytes, instead of going back to
/// the system each time. Sums of large outlines make and free blocks of megabytes by the thousand, and each that comes anew
/// from the system has to be cleared page by page, which takes a tenth to a third of their time. Programs call it first in
/// main.
void keepFreedMemory() noexcept;

}  // namespace blossom
