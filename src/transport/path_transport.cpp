#include "transport/path_transport.h"

#include <fstream>

#include "transport/bulk_file.h"
#include "transport/numbers.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

Value cutterValue(const Cutter& c) { return Value::array({c.diameter, c.cornerRadius, c.vAngle, c.number, c.spindle}); }

Cutter toCutter(const Value& v) { return {v.at(0), v.at(1), v.at(2), v.at(3), v.at(4)}; }

Value taskValue(const std::optional<PocketTask>& task) {
  return task ? Value::array({vectorValue(task->zero), task->depth, task->leaveWall, task->leaveFloor}) : Value();
}

std::optional<PocketTask> toTask(const Value& v) {
  if (v.is_null()) return std::nullopt;
  return PocketTask{toVector<Vec3>(v.at(0)), v.at(1), v.at(2), v.at(3)};
}

Value numberValue(const std::optional<double>& number) { return number ? Value(*number) : Value(); }
std::optional<double> toNumber(const Value& v) { return v.is_null() ? std::nullopt : std::optional(v.get<double>()); }

}  // namespace

Value saveToolpath(const Toolpath& path, const fs::path& folder, const std::string& name) {
  const fs::path file = folder / (name + ".path");
  std::ofstream stream(file, std::ios::binary);
  writeArray(stream, path.moves);
  writeArray(stream, path.marks);
  finishBulkFile(stream, file);
  return {{"file", file.filename().string()},
          {"cutter", cutterValue(path.cutter)},
          {"start", vectorValue(path.start)},
          {"rapid_feed", path.rapidFeed},
          {"stock", boundsValue(path.stock)},
          {"work_offset", path.workOffset},
          {"blending", path.blending},
          {"flood", path.flood},
          {"mist", path.mist},
          {"task", taskValue(path.task)},
          {"centred", path.centred},
          {"passes", path.passes},
          {"gouge", numberValue(path.gouge)},
          {"residue", numberValue(path.residue)}};
}

Toolpath loadToolpath(const Value& v, const fs::path& folder) {
  std::ifstream stream(folder / v.at("file").get<std::string>(), std::ios::binary);
  Toolpath path;
  path.moves = readArray<ToolMove>(stream);
  path.marks = readArray<ToolMark>(stream);
  path.cutter = toCutter(v.at("cutter"));
  path.start = toVector<Vec3>(v.at("start"));
  path.rapidFeed = v.at("rapid_feed");
  path.stock = toBounds(v.at("stock"));
  path.workOffset = v.at("work_offset");
  path.blending = v.at("blending");
  path.flood = v.at("flood");
  path.mist = v.at("mist");
  path.task = toTask(v.at("task"));
  path.centred = v.at("centred");
  path.passes = v.at("passes");
  path.gouge = toNumber(v.at("gouge"));
  path.residue = toNumber(v.at("residue"));
  return path;
}

Value saveMedialAxis(const MedialAxis& axis, const fs::path& folder, const std::string& name) {
  const fs::path file = folder / (name + ".axis");
  std::ofstream stream(file, std::ios::binary);
  std::vector<std::size_t> ends;
  writeArray(stream, axis.vertices);
  for (const MedialEdge& edge : axis.edges) ends.insert(ends.end(), {edge.from, edge.to});
  writeArray(stream, ends);
  for (const MedialEdge& edge : axis.edges) {
    writeArray(stream, edge.points);
    writeArray(stream, edge.feet);
  }
  finishBulkFile(stream, file);
  return {{"file", file.filename().string()}};
}

MedialAxis loadMedialAxis(const Value& v, const fs::path& folder) {
  std::ifstream stream(folder / v.at("file").get<std::string>(), std::ios::binary);
  MedialAxis axis;
  axis.vertices = readArray<MedialVertex>(stream);
  const auto ends = readArray<std::size_t>(stream);
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    MedialEdge edge{ends[k], ends[k + 1], readArray<Vec3>(stream), {}};
    edge.feet = readArray<MedialFeet>(stream);
    axis.edges.push_back(std::move(edge));
  }
  return axis;
}

}  // namespace blossom
