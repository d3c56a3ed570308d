// SPDX-License-Identifier: MIT
#include "app/number_option.h"

#include <cmath>
#include <string>

namespace inkbench {

CLI::Validator finite_not_negative() {
  return {[](const std::string& text) -> std::string {
            double number = 0;
            const bool is_number = CLI::detail::lexical_cast(text, number);
            return is_number && std::isfinite(number) && number >= 0
                       ? ""
                       : "'" + text + "' is no number of 0 or more";
          },
          "NUMBER"};
}

}  // namespace inkbench
