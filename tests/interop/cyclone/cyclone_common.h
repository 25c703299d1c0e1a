// What programs on Eclipse Cyclone DDS share: the loopback configuration, topics as ROS 2 names them, bounded waits.
#pragma once

#include <dds/dds.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

// Loopback only, unicast only; the peer is tried on the ports of the first 32 participants.
static const char kConfig[] =
    "<General><Interfaces><NetworkInterface name=\"lo\" multicast=\"false\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</"
    "MaxAutoParticipantIndex>"
    "<Peers><Peer Address=\"127.0.0.1\"/></Peers></Discovery>";

static inline dds_entity_t checked(dds_return_t result, const char* what) {
  if (result < 0) {
    fprintf(stderr, "%s: %s\n", what, dds_strretcode(-result));
    exit(2);
  }
  return result;
}

// A participant on the domain of the environment.
static inline dds_entity_t join_domain(void) {
  const char* domain = getenv("ROS_DOMAIN_ID");
  const dds_domainid_t id = domain ? (dds_domainid_t)atoi(domain) : 0;
  checked(dds_create_domain(id, kConfig), "domain");
  return checked(dds_create_participant(id, NULL, NULL), "participant");
}

// The topic as ROS 2 names it. The IDL compiler knows the type by its plain name, `pkg::msg::Name`.
static inline dds_entity_t ros_topic(dds_entity_t participant, const dds_topic_descriptor_t* plain,
                                     const char* type, const char* topic) {
  dds_topic_descriptor_t mangled = *plain;
  mangled.m_typename = type;
  return checked(dds_create_topic(participant, &mangled, topic, NULL, NULL), topic);
}
