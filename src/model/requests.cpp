// SPDX-License-Identifier: Apache-2.0
#include "model/requests.hpp"

#include "model/history_files.hpp"

namespace nugget::model {

Request& Requests::operator[](HistoryName file) {
  return histories[std::string(file.text())];
}

const Request& Requests::operator[](HistoryName file) const {
  static const Request not_asked;
  const auto found = histories.find(file.text());
  return found == histories.end() ? not_asked : found->second;
}

}  // namespace nugget::model
