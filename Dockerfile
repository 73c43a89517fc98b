# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
#
#   docker build -t clothfit .
#   docker run --rm -v "$PWD:/work" clothfit fit /usr/share/clothfit/data/demo -o runs/demo
FROM debian:12 AS build
RUN apt-get update && apt-get install -y --no-install-recommends make
COPY . /clothfit
WORKDIR /clothfit
RUN make deb

FROM debian:12
COPY --from=build /clothfit/build/deb/packages/*.deb /packages/
RUN apt-get update && apt-get install -y --no-install-recommends /packages/*.deb \
    && rm -rf /packages /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["clothfit"]
