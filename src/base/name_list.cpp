#include "base/name_list.h"

#include <algorithm>

namespace synthetic_dataset::base {

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string list;
  const std::size_t named = std::min(names.size(), most);
  for (std::size_t i = 0; i < named; ++i) list += (i == 0 ? "" : ", ") + names[i];
  const std::size_t more = names.size() - named;
  return more == 0 ? list : list + " and " + std::to_string(more) + " more";
}

}  // namespace synthetic_dataset::base
