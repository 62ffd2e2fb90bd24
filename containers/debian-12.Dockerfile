# An image that makes datasets, without compilers and sources (docs/containers.md):
#   docker build -f containers/debian-12.Dockerfile -t synthetic_dataset .
# The first stage alone is what .devcontainer develops in.
FROM debian:12 AS development
COPY scripts/install_dependencies.sh /tmp/scripts/
RUN /tmp/scripts/install_dependencies.sh && rm -rf /var/lib/apt/lists/*

FROM development AS build
COPY . /synthetic_dataset
RUN /synthetic_dataset/scripts/make_install_space.sh /opt/synthetic_dataset

FROM debian:12-slim
COPY --from=build /opt/synthetic_dataset/packages.txt /opt/synthetic_dataset/
RUN apt-get update -q \
    && xargs apt-get install -y -q --no-install-recommends </opt/synthetic_dataset/packages.txt \
    && rm -rf /var/lib/apt/lists/*
COPY --from=build /opt/synthetic_dataset /opt/synthetic_dataset
ENV PATH=/opt/synthetic_dataset/lib/synthetic_dataset:$PATH
ENTRYPOINT ["/opt/synthetic_dataset/env.sh"]
CMD ["generate", "--help"]
