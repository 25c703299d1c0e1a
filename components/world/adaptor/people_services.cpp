#include "components/world/adaptor/people_services.hpp"

#include <string>

#include <bandwagon_msgs/srv/add_person.hpp>
#include <bandwagon_msgs/srv/push_person.hpp>

namespace bw {
namespace {

using bandwagon_msgs::srv::AddPerson;
using bandwagon_msgs::srv::PushPerson;

NewPerson person_of(const AddPerson::Request& request, double usual_radius) {
  NewPerson person;
  person.position = {request.position().x(), request.position().y()};
  person.velocity = {request.velocity().x(), request.velocity().y()};
  if (request.use_goal()) person.goal = Vector2(request.goal().x(), request.goal().y());
  person.radius = request.radius() == 0.0 ? usual_radius : request.radius();
  return person;
}

template <class Response>
Response outcome(const std::string& refusal) {
  Response response;
  response.success(refusal.empty());
  response.message(refusal);
  return response;
}

}  // namespace

void offer_people_services(Setup& setup, World& world, double usual_radius) {
  setup.service<AddPerson>(
      "add_person",
      [&world, usual_radius, log = setup.log()](const AddPerson::Request& request, const Tick&) {
        const World::Admission admission = world.add_person(person_of(request, usual_radius));
        auto response = outcome<AddPerson::Response>(admission.refusal);
        response.id(admission.id);
        if (response.success())
          log.info("person {} joins at ({:.2f}, {:.2f})", admission.id, request.position().x(),
                   request.position().y());
        return response;
      },
      outcome<AddPerson::Response>);
  setup.service<PushPerson>(
      "push_person",
      [&world, log = setup.log()](const PushPerson::Request& request, const Tick&) {
        const Vector2 change{request.velocity_change().x(), request.velocity_change().y()};
        const auto response = outcome<PushPerson::Response>(world.push_person(request.id(), change));
        if (response.success())
          log.info("person {} is pushed by ({:.2f}, {:.2f}) m/s", request.id(), change.x(), change.y());
        return response;
      },
      outcome<PushPerson::Response>);
}

}  // namespace bw
