#include "core/export/export_mat_value.h"

#include <array>
#include <boost/locale/encoding_utf.hpp>

namespace fyd::exports {
namespace {

MatValue column(const char* name, const double* values, std::size_t count, int options) {
  std::array<std::size_t, 2> size{count, 1};
  // libmatio takes a non-const pointer but only reads through it.
  return MatValue(
      Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), const_cast<double*>(values), options));
}

}  // namespace

MatValue matText(const char* name, std::string_view utf8) {
  std::u16string text =
      boost::locale::conv::utf_to_utf<char16_t>(utf8.data(), utf8.data() + utf8.size(), boost::locale::conv::skip);
  std::array<std::size_t, 2> size{text.empty() ? 0U : 1U, text.size()};
  return MatValue(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF16, 2, size.data(), text.data(), 0));
}

MatValue matColumn(const char* name, const std::vector<double>& values) {
  return column(name, values.data(), values.size(), 0);
}

MatValue matColumnInPlace(const char* name, const double* values, std::size_t count) {
  return column(name, values, count, MAT_F_DONT_COPY_DATA);
}

MatValue matTexts(const char* name, const std::vector<std::string>& texts) {
  std::array<std::size_t, 2> size{texts.size(), 1};
  MatValue cell(Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, size.data(), nullptr, 0));
  for (std::size_t i = 0; cell && i < texts.size(); ++i) {
    Mat_VarSetCell(cell.get(), static_cast<int>(i), matText(nullptr, texts[i]).release());
  }
  return cell;
}

MatValue matStruct(const char* name, std::vector<std::pair<std::string, MatValue>> fields) {
  std::vector<const char*> names;
  for (const auto& [field, value] : fields) {
    if (!value) return nullptr;
    names.push_back(field.c_str());
  }
  std::array<std::size_t, 2> size{1, 1};
  MatValue result(Mat_VarCreateStruct(name, 2, size.data(), names.data(), static_cast<unsigned>(names.size())));
  for (std::pair<std::string, MatValue>& field : fields) {
    if (result) Mat_VarSetStructFieldByName(result.get(), field.first.c_str(), 0, field.second.release());
  }
  return result;
}

}  // namespace fyd::exports
