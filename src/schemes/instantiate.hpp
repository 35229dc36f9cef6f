#pragma once

#include "kernels/smoothing/list.hpp"
#include "kernels/terms/pressure_work.hpp"
#include "src/engine/passes_of.hpp"
#include "src/schemes/instantiation.hpp"
#include "src/schemes/kernel_table.hpp"

namespace sphk {

namespace detail {

template <class K>
K make_kernel(const std::string& name) {
  if constexpr (std::is_same_v<K, Tabulated>)
    return kernel_table(name);
  else
    return K{};
}

template <class S>
std::unique_ptr<Simulation> make_engine(const ParticleSet& particles, const SimulationSettings& settings) {
  return make_run<BaseLayout<typename S::Layout>>(
      particles, settings, std::make_unique<PassesOf<S>>(make_kernel<typename S::Kernel>(settings.kernel)));
}

/// What schemes that differ in kernel and pair arithmetic alone have in common.
template <class M>
SchemeDescription describe_model() {
  using L = typename M::Layout;
  using Steps = typename M::Steps;
  using Terms = typename M::Terms;
  SchemeDescription description;
  description.dimension = L::dimension;
  [&]<class... P>(Passes<P...>) { (description.passes.emplace_back(P::name), ...); }(Steps{});
  for_each_type(Terms{}, [&]<class T>() { description.terms.emplace_back(T::name); });
  for_each_type(typename L::Fields{}, [&]<class F>() { description.fields.emplace_back(F::name); });
  for_each_type(typename Steps::Writes{}, [&]<class F>() {
    if constexpr (!contains<F, typename L::Fields>)
      description.left_out.push_back(std::string(F::name) + ": no term of this scheme reads them");
  });
  if constexpr (!contains<PressureWork, Terms>)
    description.left_out.push_back("pressure work: the entropy function changes by dissipation alone");
  return description;
}

template <class S>
SchemeDescription describe_scheme() {
  SchemeDescription description = describe_model<typename S::Model>();
  description.precision = std::is_same_v<typename S::PairNumber, float> ? "mixed" : "double";
  description.bytes_per_particle = bytes_per_particle<typename S::Layout>;
  description.flops_per_pair = flops_per_pair<S>();
  return description;
}

template <template <int, class, class> class S, int D, class T, class... K>
void append(Instantiations& rows, const std::string& scheme, const std::string& energy, List<K...>,
            Masses masses = Masses::any) {
  const std::string precision = std::is_same_v<T, float> ? "mixed" : "double";
  [[maybe_unused]] const auto add = [&]<class Kernel>() {
    std::string kernel;
    if constexpr (!std::is_same_v<Kernel, Tabulated>) kernel = Kernel::name;
    using Instance = S<D, Kernel, T>;
    rows.push_back({scheme, energy, D, precision, kernel, masses, make_engine<Instance>, describe_scheme<Instance>});
  };
  (add.template operator()<K>(), ...);
}

}  // namespace detail

/// Rows for scheme S in D dimensions: mixed and double, with the curated kernels and with the table for all others.
template <template <int, class, class> class S, int D, class... K>
Instantiations instantiate(const std::string& scheme, const std::string& energy, List<K...> curated,
                           Masses masses = Masses::any) {
  Instantiations rows;
  detail::append<S, D, float>(rows, scheme, energy, curated, masses);
  detail::append<S, D, double>(rows, scheme, energy, curated, masses);
  detail::append<S, D, float>(rows, scheme, energy, List<Tabulated>{}, masses);
  detail::append<S, D, double>(rows, scheme, energy, List<Tabulated>{}, masses);
  return rows;
}

}  // namespace sphk
