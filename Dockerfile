# syntax=docker/dockerfile:1
FROM rust:1.95-bookworm AS build
WORKDIR /src
COPY . .
RUN --mount=type=cache,target=/usr/local/cargo/registry --mount=type=cache,target=/src/target \
    cargo build --release --locked && cp target/release/plateau /plateau

FROM gcr.io/distroless/cc-debian12:nonroot
COPY --from=build /plateau /usr/local/bin/plateau
ENV PLATEAU_LISTEN=0.0.0.0:8080 PLATEAU_DATA=/data
VOLUME /data
EXPOSE 8080
ENTRYPOINT ["/usr/local/bin/plateau"]
