// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/core/type_list.hpp"
#include "kernels/terms/term_set.hpp"
#include "src/schemes/catalogue.hpp"

namespace sphk {

/// The entry of scheme S: a struct with `facts` and a list of Recipes, as those in this folder.
template <class S>
SchemeEntry scheme_entry() {
  SchemeEntry entry{&S::facts, {}, {}};
  for_each_type(typename S::Recipes{}, [&]<class R>() {
    if (!entry.integrates(R::ThermalForm::name)) entry.energies.push_back(R::ThermalForm::name);
    for_each_type(Union<typename R::RateTerms::List, typename R::StepPasses>{}, [&]<class P>() {
      for (const Number* number : NumbersOf<P>::type::list)
        if (!entry.number(number->key)) entry.numbers.push_back(number);
    });
  });
  return entry;
}

}  // namespace sphk
