#include "results/evaluated_transport.h"

#include "transport/shape_transport.h"

namespace blossom {

namespace {

Value figuresValue(const std::vector<Measure>& figures) {
  Value all = Value::array();
  for (const Measure& figure : figures) {
    Value each{{"name", figure.name}, {"unit", static_cast<int>(figure.unit)}};
    std::visit([&](const auto& value) { each["value"] = value; }, figure.value);
    all.push_back(std::move(each));
  }
  return all;
}

std::vector<Measure> toFigures(const Value& all) {
  std::vector<Measure> figures;
  for (const Value& each : all) {
    Measure figure{each.at("name"), false, static_cast<MeasureUnit>(each.at("unit").get<int>())};
    const Value& value = each.at("value");
    if (value.is_boolean())
      figure.value = value.get<bool>();
    else if (value.is_number_integer())
      figure.value = value.get<std::int64_t>();
    else if (value.is_number())
      figure.value = value.get<double>();
    else
      figure.value = value.get<std::string>();
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace

Value saveEvaluated(const Evaluated& made, const std::filesystem::path& folder, const std::string& name) {
  return {{"shape", saveShape(made.shape, folder, name)},
          {"stats", made.stats},
          {"warnings", made.warnings},
          {"figures", figuresValue(made.figures)}};
}

Evaluated loadEvaluated(const Value& value, const std::filesystem::path& folder) {
  return {loadShape(value.at("shape"), folder), value.at("stats"), value.at("warnings").get<std::vector<std::string>>(),
          toFigures(value.at("figures"))};
}

}  // namespace blossom
