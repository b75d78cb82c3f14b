// A row of /inputs/steps: the numbers among a step's inputs, and where in their tables the others stand.
#pragma once

#include "core/pipeline/inputs.h"

namespace fyd::recording {

inline constexpr auto kInputTables = pipeline::Inputs::tables();
inline constexpr std::size_t kInputTableCount = std::tuple_size_v<std::remove_const_t<decltype(kInputTables)>>;
inline constexpr std::uint64_t kNoRow = ~std::uint64_t{0};  ///< in StepRow: there is none, or it is lost

template <class V>
inline constexpr bool kIsList = false;
template <class V, std::size_t N>
inline constexpr bool kIsList<Batch<V, N>> = true;

/// Of each of the inputs' tables, and of /events, which is the last: the row of the value, or of the first of a list.
struct StepPlaces {
  StepPlaces() { row.fill(kNoRow); }
  std::array<std::uint64_t, kInputTableCount + 1> row{};
  std::array<std::uint8_t, kInputTableCount + 1> count{};
};

/// @tparam Inputs pipeline::Inputs, const where the row is written
template <class Inputs>
struct StepRow {
  Inputs& inputs;
  StepPlaces places;

  static constexpr auto fields() {
    return std::tuple_cat(numbers<true>(), eachTable([](auto, const auto& table, std::size_t i) {
                            return std::tuple(rowField(table.name(), i));
                          }),
                          std::tuple(rowField("events", kInputTableCount)),
                          eachTable([]<class V>(std::type_identity<V>, const auto& table, std::size_t i) {
                            if constexpr (kIsList<V>)
                              return std::tuple(countField(table.name(), i));
                            else
                              return std::tuple();
                          }),
                          std::tuple(countField("events", kInputTableCount)), numbers<false>());
  }

 private:
  static constexpr auto rowField(std::string_view name, std::size_t i) {
    Field field(
        name, "1", "row in its table; of a list the first", [i](auto& s) -> auto& { return s.places.row[i]; });
    field.ending = "_row";
    return field;
  }
  static constexpr auto countField(std::string_view name, std::size_t i) {
    return Field(
        name, "1", "how many of them came", [i](auto& s) -> auto& { return s.places.count[i]; });
  }
  /// Those of more than a byte stand before the places, the others behind.
  template <bool kWide>
  static constexpr auto numbers() {
    return std::apply(
        [](const auto&... field) {
          const auto one = [](const auto& each) {
            if constexpr ((sizeof(FieldValue<decltype(each), pipeline::Inputs>) > 1) == kWide)
              return std::tuple(Field(each.name, each.unit, each.help,
                                      inside(
                                          [](auto& s) -> auto& { return s.inputs; }, each.member)));
            else
              return std::tuple();
          };
          return std::tuple_cat(one(field)...);
        },
        kFieldsOf<pipeline::Inputs>);
  }
  template <class Make>
  static constexpr auto eachTable(Make make) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::tuple_cat(
          make(std::type_identity<FieldValue<decltype(std::get<I>(kInputTables)), pipeline::Inputs>>(),
               std::get<I>(kInputTables), I)...);
    }
    (std::make_index_sequence<kInputTableCount>());
  }
};

/// What a row can be read into, or written from.
using ReadStepRow = StepRow<pipeline::Inputs>;
using WrittenStepRow = StepRow<const pipeline::Inputs>;

}  // namespace fyd::recording
