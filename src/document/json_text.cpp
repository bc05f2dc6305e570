#include "document/json_text.h"

namespace blossom {
namespace {

constexpr std::size_t widestLine = 120;

std::string compact(const Value& value) { return value.dump(-1, ' ', false, Value::error_handler_t::replace); }

/// `compact` with blanks after commas and colons, where it is not inside a string.
std::string spaced(const std::string& text) {
  std::string result;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (inString && text[i] == '\\') {
      result += text[++i];
    } else if (text[i] == '"') {
      inString = !inString;
    } else if (!inString && (text[i] == ',' || text[i] == ':')) {
      result += ' ';
    }
  }
  return result;
}

void append(std::string& out, const Value& value, std::size_t indent) {
  const std::string line = spaced(compact(value));
  if (!value.is_structured() || value.empty() || (line.size() + indent <= widestLine && indent > 0)) {
    out += line;
    return;
  }
  out += value.is_object() ? "{\n" : "[\n";
  bool first = true;
  for (const auto& [key, item] : value.items()) {
    if (!first) out += ",\n";
    first = false;
    out.append(indent + 2, ' ');
    if (value.is_object()) out += compact(key) + ": ";
    append(out, item, indent + 2);
  }
  out += '\n';
  out.append(indent, ' ');
  out += value.is_object() ? '}' : ']';
}

/// Place after the string that begins at `at`; npos when it has no end.
std::size_t afterString(const std::string& text, std::size_t at) {
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      return i + 1;
  }
  return std::string::npos;
}

}  // namespace

std::string prettyJson(const Value& value) {
  std::string out;
  append(out, value, 0);
  return out + "\n";
}

std::vector<std::string> completeObjects(const std::string& json, const std::string& key) {
  std::vector<std::string> objects;
  std::size_t at = json.find('"' + key + '"');
  if (at == std::string::npos || (at = json.find('[', at)) == std::string::npos) return objects;
  std::size_t start = 0;
  int depth = 0;
  for (++at; at < json.size();) {
    const char c = json[at];
    if (c == '"') {
      at = afterString(json, at);
      if (at == std::string::npos) break;
      continue;
    }
    if ((c == '{' || c == '[') && depth++ == 0) start = at;
    if (c == '}' || c == ']') {
      if (depth == 0) break;  // the end of the array
      if (--depth == 0 && c == '}') objects.push_back(json.substr(start, at + 1 - start));
    }
    ++at;
  }
  return objects;
}

}  // namespace blossom
