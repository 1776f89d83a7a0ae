#include "reports/json/json_field.h"

#include "reports/json/json_read.h"

namespace report {
namespace {

/// For people: short, on one line, and printable whatever the file holds.
std::string shown(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

}  // namespace

void Field::refuse(const std::string& expected) const {
  throw ReadError(*m_file, m_path, "found " + shown(*m_value) + ", expected " + expected);
}

std::string Field::child(const std::string& key) const {
  return m_path.empty() ? key : m_path + "." + key;
}

void Field::requireObject() const {
  if (!m_value->is_object()) refuse("an object");
}

Field Field::at(const std::string& key) const {
  requireObject();
  const auto found = m_value->find(key);
  if (found == m_value->end())
    throw ReadError(*m_file, child(key), "found nothing, expected this key");
  return {*found, *m_file, child(key)};
}

std::optional<Field> Field::find(const std::string& key) const {
  requireObject();
  const auto found = m_value->find(key);
  if (found == m_value->end() || found->is_null()) return {};
  return Field(*found, *m_file, child(key));
}

std::vector<Field> Field::items() const {
  if (!m_value->is_array()) refuse("a list");
  std::vector<Field> out;
  for (size_t i = 0; i < m_value->size(); ++i)
    out.push_back({(*m_value)[i], *m_file, m_path + "[" + std::to_string(i) + "]"});
  return out;
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  requireObject();
  std::vector<std::pair<std::string, Field>> out;
  for (auto it = m_value->begin(); it != m_value->end(); ++it)
    out.emplace_back(it.key(), Field(it.value(), *m_file, child(it.key())));
  return out;
}

std::string Field::text() const {
  if (!m_value->is_string()) refuse("a text");
  return m_value->get<std::string>();
}

bool Field::boolean() const {
  if (!m_value->is_boolean()) refuse("true or false");
  return m_value->get<bool>();
}

double Field::number() const {
  if (!m_value->is_number()) refuse("a number");
  const double value = m_value->get<double>();
  if (!std::isfinite(value)) refuse("a finite number");
  return value;
}

uint64_t Field::integerWithin(uint64_t most) const {
  const std::string expected = "a whole number of 0 to " + std::to_string(most);
  if (!m_value->is_number_unsigned() || m_value->get<uint64_t>() > most) refuse(expected);
  return m_value->get<uint64_t>();
}

int Field::signedInteger() const {
  if (!m_value->is_number_integer() || std::abs(number()) > std::numeric_limits<int>::max())
    refuse("a whole number");
  return m_value->get<int>();
}

std::string textOf(const Field& entry, const std::string& key) {
  const auto found = entry.find(key);
  return found ? found->text() : "";
}

std::vector<std::string> textsOf(const Field& entry, const std::string& key) {
  std::vector<std::string> out;
  if (auto found = entry.find(key))
    for (const Field& item : found->items()) out.push_back(item.text());
  return out;
}

uint64_t countOf(const Field& entry, const std::string& key) {
  const auto found = entry.find(key);
  return found ? found->integer<uint64_t>() : 0;
}

std::optional<double> numberOf(const Field& entry, const std::string& key) {
  const auto found = entry.find(key);
  return found ? std::optional(found->number()) : std::nullopt;
}

}  // namespace report
