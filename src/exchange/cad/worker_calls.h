#pragma once

namespace blossom {

/// Registers the readers and writers of STEP, IGES and BREP in `blossom-worker`.
void registerExchangeCalls();

}  // namespace blossom
