#include "transport/bulk_file.h"

#include "core/error.h"

namespace blossom {

void finishBulkFile(std::ofstream& stream, const std::filesystem::path& file) {
  stream.close();
  if (!stream)
    throw Error(ErrorCode::FileUnwritable,
                "There is no room for temporary files in \"" + file.parent_path().string() + "\".", "Free some disk space.");
}

void throwUnreadableShapes() { throw Error(ErrorCode::Internal, "The shapes of a helper process cannot be read."); }

}  // namespace blossom
