# An image that makes datasets on ROS Noetic, without compilers and sources (docs/containers.md):
#   docker build -f containers/noetic.Dockerfile -t synthetic_dataset:noetic .
FROM ros:noetic AS build
COPY package.xml /synthetic_dataset/
COPY scripts/install_dependencies.sh /synthetic_dataset/scripts/
RUN /synthetic_dataset/scripts/install_dependencies.sh
COPY . /synthetic_dataset
RUN /synthetic_dataset/scripts/make_install_space.sh /opt/synthetic_dataset

FROM ros:noetic-ros-core
COPY --from=build /opt/synthetic_dataset/packages.txt /opt/synthetic_dataset/
RUN apt-get update -q \
    && xargs apt-get install -y -q --no-install-recommends </opt/synthetic_dataset/packages.txt \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/synthetic_dataset /opt/synthetic_dataset
ENV PATH=/opt/synthetic_dataset/lib/synthetic_dataset:$PATH
ENTRYPOINT ["/opt/synthetic_dataset/env.sh"]
CMD ["generate", "--help"]
